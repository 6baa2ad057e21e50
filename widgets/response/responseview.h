// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <QWidget>
#include <vector>

#include "model/response/responsefile.h"
#include "widgets/common/filedialog.h"

class QHBoxLayout;
class QTableWidget;
class QToolButton;

namespace nmc {

struct Picture;
class Requests;
class ResponsePlot;

/// The step plot with its buttons, the readings of its cursors, and the export of its picture.
class ResponseView : public QWidget {
    Q_OBJECT

public:
    explicit ResponseView(Requests& requests, QWidget* parent = nullptr);

    [[nodiscard]] ResponsePlot& plot() { return *m_plot; }
    /// As ResponsePlot::showRuns().
    void showRuns(const KeptResponse* a, const KeptResponse* b,
                  const std::vector<const KeptResponse*>& others);
    /// Adds a control beside its buttons.
    void addControl(QWidget* control);

private:
    QToolButton* newButton(const QString& objectName, const QString& text, const QString& meaning);
    void buildMenu();
    void showCursors(bool shown);
    void showReadings();
    void choose(const QString& suffix);
    void copy();
    [[nodiscard]] Picture picture() const;

    Requests& m_requests;
    ResponsePlot* m_plot;
    QTableWidget* m_readings;
    QHBoxLayout* m_bar;
    QString m_folder;
    QStringList m_shown;  ///< the runs, in words
};

}  // namespace nmc
