// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <vector>

class QToolButton;

namespace nmc {

class CursorTable;
class History;
class ScopeStrips;
class StretchDialog;

/// The cursor readings: a line that shows how far apart the cursors are, and below it a table that folds into
/// that line. Beside the line, buttons open windows about what is between the cursors.
class CursorPanel : public QWidget {
    Q_OBJECT

public:
    explicit CursorPanel(QWidget* parent);

    void setUnfolded(bool unfolded);
    /// True if the panel is beside the strips, and as high as they are; false if it is below them.
    void setBeside(bool beside);
    /// Updates the line and, while they are visible, table and windows. Returns false if another call is
    /// needed, as CursorTable::showReadings() does.
    bool showReadings(const ScopeStrips& strips, const History& history);

signals:
    void unfoldRequested(bool unfolded);
    /// showReadings() must be called soon.
    void frameWanted();

protected:
    void hideEvent(QHideEvent* event) override;

private:
    /// `Dialog`: a StretchDialog, which is made when it is first opened.
    template <typename Dialog>
    [[nodiscard]] QToolButton* newOpener(const QString& objectName, const QString& text,
                                         const QString& meaning);

    QToolButton* m_fold;
    CursorTable* m_table;
    std::vector<StretchDialog*> m_dialogs;
};

}  // namespace nmc
