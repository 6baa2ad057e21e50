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

/// Shows the manual: pages, links, pages read before, and a search within the page. Not modal: the panel,
/// including STOP ALL, stays usable.
class ManualWindow : public QDialog {
    Q_OBJECT

public:
    ManualWindow(const Manual& manual, QWidget* parent);

    /// Opens the window, or brings it to the front. `page`: as Manual::pageOf() returns it.
    void openAt(const QString& page);
    /// Opens it at what the manual says about this widget; null: at the index.
    void openFor(const QWidget* widget) { openAt(m_manual.pageOf(widget)); }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QPushButton* newButton(const QString& objectName, const QString& text, const QString& toolTip,
                           const QKeySequence& key);
    [[nodiscard]] QHBoxLayout* buildTop();
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
