// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHash>
#include <QList>
#include <QString>

class QWidget;

namespace nmc {

/// The pages of docs/manual, which are Markdown. Their own anchors are object names of widgets, so that F1
/// finds what a page says of the widget that has the focus. GUI thread.
class Manual {
public:
    struct Page {
        QString file;   ///< "homing.md"
        QString title;  ///< its first heading
    };

    /// Where the pages lie that came with this program, built or installed.
    [[nodiscard]] static QString installedFolder();
    inline static const QString kIndex = QStringLiteral("index.md");

    explicit Manual(QString folder = installedFolder());

    [[nodiscard]] const QString& folder() const { return m_folder; }
    /// The index, then the pages in the order in which it names them. Empty: there is no manual.
    [[nodiscard]] const QList<Page>& pages() const { return m_pages; }
    /// "homing.md#limitStopBox": of this widget, or of the innermost around it that the manual knows. On a
    /// bar of tabs, of the tab that is shown. Else the index.
    [[nodiscard]] QString pageOf(const QWidget* widget) const;

    /// What a page shows, with the anchors of its headings and its own.
    [[nodiscard]] static QString html(const QString& markdown);

private:
    void add(const QString& file);
    [[nodiscard]] QString anchored(const QWidget& widget) const;

    QString m_folder;
    QList<Page> m_pages;
    QHash<QString, QString> m_anchors;  ///< page by object name
};

}  // namespace nmc
