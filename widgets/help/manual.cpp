// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/help/manual.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QPalette>
#include <QRegularExpression>
#include <QTabWidget>
#include <QTextBlock>
#include <QTextDocument>
#include <QTextTable>
#include <utility>

#include "widgets/common/look.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {

QString read(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

const QRegularExpression& ownAnchor() {
    static const QRegularExpression expression(u"<a id=\"(\\w+)\"></a>"_s);
    return expression;
}

/// The anchor of a heading, as GitHub and scripts/check_docs.py make it.
QString slug(const QString& heading) {
    static const QRegularExpression dropped(u"[^\\w\\- ]"_s, QRegularExpression::UseUnicodePropertiesOption);
    return heading.trimmed().toLower().remove(dropped).replace(u' ', u'-');
}

/// Names the first visible character from `position` on that has no name yet, because toHtml() keeps only one
/// name per character.
void anchor(QTextDocument& document, int position, const QString& name) {
    QTextCursor cursor(&document);
    do {
        while (!document.characterAt(position).isPrint() && position + 1 < document.characterCount())
            ++position;
        cursor.setPosition(position++);
        cursor.movePosition(QTextCursor::NextCharacter, QTextCursor::KeepAnchor);
    } while (!cursor.charFormat().anchorNames().isEmpty() && !cursor.atEnd());
    QTextCharFormat format;
    format.setAnchor(true);
    format.setAnchorNames({name});
    cursor.mergeCharFormat(format);
}

void anchorHeadings(QTextDocument& document) {
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next())
        if (block.blockFormat().headingLevel() > 0)
            anchor(document, block.position(), slug(block.text()));
}

/// Turns marks into anchors. Qt's Markdown reader drops anchors, so each was replaced by its name between two
/// characters that no text contains.
void anchorMarks(QTextDocument& document) {
    static const QRegularExpression mark(u"\uE000\\w+\uE001"_s);
    // From last to first; otherwise an anchor could name the mark that follows it.
    QTextCursor found(&document);
    found.movePosition(QTextCursor::End);
    while (!(found = document.find(mark, found, QTextDocument::FindBackward)).isNull()) {
        const QString name = found.selectedText().chopped(1).mid(1);
        found.removeSelectedText();
        anchor(document, found.position(), name);
    }
}

/// Tests for an empty heading row: in Markdown, every table has a heading row.
bool isBlank(const QTextTable& table, int row) {
    for (int column = 0; column < table.columns(); ++column) {
        const QTextTableCell cell = table.cellAt(row, column);
        if (cell.firstCursorPosition() != cell.lastCursorPosition())
            return false;
    }
    return true;
}

void ruleTables(QTextDocument& document) {
    for (QTextFrame* frame : document.rootFrame()->childFrames())
        if (auto* table = qobject_cast<QTextTable*>(frame)) {
            QTextTableFormat format = table->format();
            format.setBorder(1);
            format.setBorderCollapse(true);
            format.setBorderBrush(QColor(0x80, 0x80, 0x80));
            format.setCellPadding(4);
            format.setCellSpacing(0);
            table->setFormat(format);
            if (isBlank(*table, 0))
                table->removeRows(0, 1);
        }
}

/// The palette's link colour, moved towards the text colour until it has a contrast of 4.5:1.
QColor linkColour(const QPalette& palette) {
    const QColor text = palette.color(QPalette::Text);
    const QColor link = palette.color(QPalette::Link);
    constexpr int kSteps = 8;
    for (int step = 0; step < kSteps; ++step) {
        const auto mixed = [step](int from, int to) { return from + (to - from) * step / kSteps; };
        const QColor colour(mixed(link.red(), text.red()), mixed(link.green(), text.green()),
                            mixed(link.blue(), text.blue()));
        if (look::contrast(colour, palette.color(QPalette::Base)) >= 4.5)
            return colour;
    }
    return text;
}

}  // namespace

QString Manual::installedFolder() {
    return QDir::cleanPath(QCoreApplication::applicationDirPath() +
                           QStringLiteral("/" NMC_DOCUMENT_FOLDER "/docs/manual"));
}

Manual::Manual(QString folder) : m_folder(std::move(folder)) {
    static const QRegularExpression row(u"^\\| \\[[^\\]]*\\]\\(([\\w-]+\\.md)\\)"_s,
                                        QRegularExpression::MultilineOption);
    add(kIndex);
    for (const auto& named : row.globalMatch(read(m_folder + u'/' + kIndex)))
        add(named.captured(1));
}

void Manual::add(const QString& file) {
    const QString text = read(m_folder + u'/' + file);
    if (text.isEmpty())
        return;
    m_pages.append({file, text.section(u'\n', 0, 0).remove(u"# "_s)});
    for (const auto& own : ownAnchor().globalMatch(text))
        m_anchors.insert(own.captured(1), file);
}

QString Manual::anchored(const QWidget& widget) const {
    const auto page = m_anchors.find(widget.objectName());
    return page == m_anchors.end() ? QString() : *page + u'#' + widget.objectName();
}

QString Manual::pageOf(const QWidget* widget) const {
    for (; widget != nullptr; widget = widget->parentWidget()) {
        if (const QString page = anchored(*widget); !page.isEmpty())
            return page;
        const auto* tabs = qobject_cast<const QTabWidget*>(widget);
        if (tabs == nullptr || tabs->currentWidget() == nullptr)
            continue;
        for (const QWidget* shown : tabs->currentWidget()->findChildren<QWidget*>())
            if (const QString page = anchored(*shown); !page.isEmpty())
                return page;
    }
    return kIndex;
}

QString Manual::html(const QString& markdown) {
    QTextDocument document;
    document.setMarkdown(QString(markdown).replace(ownAnchor(), u"\uE000\\1\uE001"_s));
    anchorMarks(document);
    anchorHeadings(document);
    ruleTables(document);
    // Qt has written the palette's own link colour into the page.
    const QPalette palette;
    return document.toHtml().replace(u"color:"_s + palette.color(QPalette::Link).name(),
                                     u"color:"_s + linkColour(palette).name());
}

}  // namespace nmc
