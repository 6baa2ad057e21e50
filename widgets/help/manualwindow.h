// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QUrl>

#include "widgets/help/manual.h"

class QHBoxLayout;
class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;

namespace nmc {

class ManualBrowser;

/// Reads the manual: pages, links, what was read before, and what is searched for in the page. Not modal: the
/// panel stays usable, and STOP ALL with it.
class ManualWindow : public QDialog {
    Q_OBJECT

public:
    ManualWindow(const Manual& manual, QWidget* parent);

    /// "homing.md#limitStopBox", as of Manual::pageOf(); opens the window, or brings it to the front.
    void openAt(const QString& page);
    /// At what the manual says of this widget; null for none.
    void openFor(const QWidget* widget) { openAt(m_manual.pageOf(widget)); }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QPushButton* newButton(const QString& objectName, const QString& text, const QString& toolTip,
                           const QKeySequence& key);
    void buildTop(QHBoxLayout& top);
    [[nodiscard]] QUrl urlOf(const QString& page) const;
    void follow(const QUrl& url);
    void search(bool backwards);

    Manual m_manual;
    QListWidget* m_pages;
    ManualBrowser* m_browser;
    QPushButton* m_back = nullptr;
    QPushButton* m_forward = nullptr;
    QLineEdit* m_search = nullptr;
    QLabel* m_found = nullptr;
};

}  // namespace nmc
