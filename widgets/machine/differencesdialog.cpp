// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/machine/differencesdialog.h"

#include <QHeaderView>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTreeWidget>
#include <algorithm>
#include <utility>

#include "widgets/common/form.h"
#include "widgets/common/glyphs.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/texts.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {

QIcon attention(const QWidget& widget) {
    const int side = widget.fontMetrics().height();
    const double ratio = widget.devicePixelRatioF();
    QPixmap pixmap(QSize(side, side) * ratio);
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    paintSeverity(painter, QRectF(0, 0, side, side), Severity::Attention, widget.palette());
    return pixmap;
}

/// True for parts that are a single value, named like the part; the others have named fields.
bool isSingleValue(MachinePart part) {
    using enum MachinePart;
    return part == MachineName || part == Rate || part == HomeOrder || part == Hardware || part == AxisName ||
           part == AccelerationTime;
}

/// True if none of its fields has a value here yet, so that they need not be reviewed one by one.
bool allNew(const Difference& difference) {
    return std::none_of(difference.fields.begin(), difference.fields.end(),
                        [](const FieldDifference& field) { return field.now.has_value(); });
}

/// The name of a row; includes the field if the part has several and only one differs.
QString whatOf(const Difference& difference) {
    const PartId& id = difference.id;
    QString what = texts::machinePart(id.part);
    if (difference.fields.size() == 1 && !isSingleValue(id.part))
        what += u", "_s + texts::machineField(QString::fromStdString(difference.fields.front().key),
                                              difference.scale.reversed());
    return id.module ? u"%1: %2"_s.arg(texts::moduleName(*id.module), what) : what;
}

}  // namespace

DifferencesDialog::DifferencesDialog(QWidget* parent)
    : QDialog(parent),
      m_text(form::newParagraph(u"differencesText"_s, {}, this)),
      m_table(new QTreeWidget(this)),
      m_summary(form::newParagraph(u"differencesSummary"_s, {}, this)),
      m_all(form::newPush({u"tickAllButton"_s, tr("&Select all"), tr("Select all")}, this)),
      m_none(form::newPush({u"tickNoneButton"_s, tr("Clear a&ll"), tr("Clear all")}, this)),
      m_apply(form::newPush({u"applyDifferencesButton"_s, tr("&Apply"), tr("Apply")}, this)),
      m_cancel(form::newPush({u"cancelDifferencesButton"_s, tr("&Cancel"), Common::tr("Cancel")}, this)) {
    setObjectName(u"differencesDialog"_s);
    setAttribute(Qt::WA_DeleteOnClose);
    build();
    connect(m_table, &QTreeWidget::itemChanged, this, &DifferencesDialog::summarise);
    connect(m_all, &QPushButton::clicked, this, [this] { tickAll(true); });
    connect(m_none, &QPushButton::clicked, this, [this] { tickAll(false); });
    connect(m_cancel, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_apply, &QPushButton::clicked, this, [this] { emit applyRequested(chosen()); });
}

void DifferencesDialog::build() {
    look::name(m_table, u"differencesTable"_s, tr("Differences from the present settings"));
    m_table->header()->setObjectName(u"differencesHeader"_s);
    m_table->setColumnCount(kColumns);
    m_table->setAllColumnsShowFocus(true);
    m_table->setAlternatingRowColors(true);
    m_table->setUniformRowHeights(true);
    m_all->setToolTip(tr("Selects all check boxes, including settings sent to modules that are on."));
    m_none->setToolTip(tr("Clears all check boxes."));
    m_cancel->setToolTip(tr("Keeps everything as it is."));
    // Sending requires a click on the button itself, not an Enter that was meant for something else.
    for (QPushButton* button : {m_all, m_none, m_apply, m_cancel})
        button->setAutoDefault(false);

    auto* buttons = form::newLine(this, {m_all, m_none, nullptr, m_apply, m_cancel}, 0.5);
    form::fill(this, form::newColumn(this, {m_text, {m_table, 1}, m_summary, buttons}), 1);
    const int em = fontMetrics().height();
    resize(em * 72, em * 40);
}

void DifferencesDialog::showDifferences(const QString& file, std::vector<Difference> differences) {
    m_text->setText(
        tr("\"%1\" differs from the current settings. Nothing is changed or sent until you choose Apply, and no motor moves. Values typed but not sent are replaced by those in the file.")
            .arg(file));
    showRows(Common::tr("Open machine"), tr("In the file"), std::move(differences));
}

void DifferencesDialog::showCopy(ModuleIndex from, std::vector<Difference> differences) {
    m_text->setText(
        tr("Settings of %1 for other axes. Nothing is changed or sent until you choose Apply, and no motor moves. Values typed but not sent are replaced.")
            .arg(texts::moduleName(from)));
    showRows(tr("Copy settings"), texts::moduleName(from), std::move(differences));
}

void DifferencesDialog::showRows(const QString& title, const QString& source,
                                 std::vector<Difference> differences) {
    setWindowTitle(title);
    setAccessibleName(tr("%1: differences").arg(title));
    m_table->setHeaderLabels({tr("Setting"), source, tr("Here or last sent"), tr("When applied")});
    {
        const QSignalBlocker blocker(m_table);
        m_table->clear();
        m_differences = std::move(differences);
        for (const Difference& difference : m_differences)
            addRow(difference);
    }
    for (const int column : {kWhat, kFile, kNow}) {
        m_table->resizeColumnToContents(column);
        m_table->setColumnWidth(column, m_table->columnWidth(column) + look::gridUnit(this) * 2);
    }
    summarise();
}

void DifferencesDialog::addRow(const Difference& difference) {
    auto* row = new QTreeWidgetItem(m_table);
    row->setSizeHint(kApplying, QSize(0, fontMetrics().height() * 3 / 2));
    row->setText(kWhat, whatOf(difference));
    row->setText(kApplying, texts::machineApplying(difference));
    row->setToolTip(kApplying, row->text(kApplying));
    const bool sent = difference.applying == Applying::Sends || difference.applying == Applying::KeepsUnsent;
    const QString unknown = sent ? tr("unknown") : u"–"_s;
    const auto fill = [&](QTreeWidgetItem& item, const FieldDifference& field) {
        item.setText(kFile, texts::machineValue(field, field.file, difference.scale, u"–"_s));
        item.setText(kNow, texts::machineValue(field, field.now, difference.scale, unknown));
    };
    if (difference.possible())
        row->setCheckState(kWhat, difference.wanted ? Qt::Checked : Qt::Unchecked);
    else
        row->setIcon(kWhat, attention(*this));
    if (difference.fields.size() == 1) {
        fill(*row, difference.fields.front());
        return;
    }
    for (const FieldDifference& field : difference.fields) {
        auto* line = new QTreeWidgetItem(row);
        line->setText(kWhat,
                      texts::machineField(QString::fromStdString(field.key), difference.scale.reversed()));
        fill(*line, field);
    }
    row->setText(kFile, tr("%1 values").arg(difference.fields.size()));
    if (allNew(difference))
        row->setText(kNow, unknown);
    else
        row->setExpanded(true);
}

bool DifferencesDialog::ticked(int row) const {
    return m_differences[static_cast<std::size_t>(row)].possible() &&
           m_table->topLevelItem(row)->checkState(kWhat) == Qt::Checked;
}

std::vector<PartId> DifferencesDialog::chosen() const {
    std::vector<PartId> ids;
    for (int row = 0; row < m_table->topLevelItemCount(); ++row)
        if (ticked(row))
            ids.push_back(m_differences[static_cast<std::size_t>(row)].id);
    return ids;
}

int DifferencesDialog::sendings() const {
    int count = 0;
    for (int row = 0; row < m_table->topLevelItemCount(); ++row)
        if (ticked(row) && m_differences[static_cast<std::size_t>(row)].applying == Applying::Sends)
            ++count;
    return count;
}

void DifferencesDialog::tickAll(bool ticked) {
    {
        const QSignalBlocker blocker(m_table);
        for (int row = 0; row < m_table->topLevelItemCount(); ++row)
            if (m_differences[static_cast<std::size_t>(row)].possible())
                m_table->topLevelItem(row)->setCheckState(kWhat, ticked ? Qt::Checked : Qt::Unchecked);
    }
    m_table->viewport()->update();
    summarise();
}

void DifferencesDialog::showMoving(int motors) {
    if (std::exchange(m_moving, motors) != motors)
        summarise();
}

void DifferencesDialog::summarise() {
    const int sent = sendings();
    const QString reason = sent > 0 && m_moving > 0 ? texts::notSentWhileMoving(m_moving) : QString();
    const int parts = static_cast<int>(chosen().size());
    const QString summary =
        tr("Selected: %1 of %2. Sent to modules: %3.").arg(parts).arg(m_table->topLevelItemCount()).arg(sent);
    look::setText(m_summary, reason.isEmpty() ? summary : summary + u' ' + reason);
    look::setPossible(m_apply, reason, tr("Applies the selected settings and sends those marked as sent."));
}

}  // namespace nmc
