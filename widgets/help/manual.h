// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHash>
#include <QList>
#include <QString>

class QWidget;

namespace nmc {

/// The pages of docs/manual, which are written in Markdown. Their own anchors are object names of widgets, so
/// that F1 finds what a page says about the focused widget. GUI thread.
class Manual {
public:
    struct Page {
        QString file;   ///< "homing.md"
        QString title;  ///< its first heading
    };

    /// The folder with the pages that belong to this program, built or installed.
    [[nodiscard]] static QString installedFolder();
    inline static const QString kIndex = QStringLiteral("index.md");

    explicit Manual(QString folder = installedFolder());

    [[nodiscard]] const QString& folder() const { return m_folder; }
    /// The index, then the pages in the order in which it names them. Empty: there is no manual.
    [[nodiscard]] const QList<Page>& pages() const { return m_pages; }
    /// The page about this widget, or about the innermost one around it that the manual describes:
    /// "homing.md#limitStopBox". For a tab widget, this includes the tab that is shown. Otherwise the index.
    [[nodiscard]] QString pageOf(const QWidget* widget) const;

    /// A page as HTML, with anchors for its headings and with its own anchors.
    [[nodiscard]] static QString html(const QString& markdown);

private:
    void add(const QString& file);
    [[nodiscard]] QString anchored(const QWidget& widget) const;

    QString m_folder;
    QList<Page> m_pages;
    QHash<QString, QString> m_anchors;  ///< page by object name
};

}  // namespace nmc
