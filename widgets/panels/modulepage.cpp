// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/modulepage.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QTabBar>
#include <QTabWidget>
#include <QTimer>
#include <QToolTip>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "widgets/common/focuskeeper.h"
#include "widgets/common/foldinggrid.h"
#include "widgets/common/form.h"
#include "widgets/common/look.h"
#include "widgets/common/palettes.h"
#include "widgets/common/scrolled.h"
#include "widgets/common/sharedwords.h"
#include "widgets/panels/command.h"
#include "widgets/panels/detailsbox.h"
#include "widgets/panels/holdbutton.h"
#include "widgets/panels/homingbox.h"
#include "widgets/panels/iovaluesbox.h"
#include "widgets/panels/movebybox.h"
#include "widgets/panels/stagedform.h"
#include "widgets/panels/stepperiobox.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {

constexpr int kNarrowestPages = 17;  ///< in heights of a text line
constexpr int kLowestPages = 3;
constexpr int kWindowChanges = 250;  ///< ms

/// Lets the area shrink, so that the status line is still visible on a screen of 540 lines.
void giveWay(QScrollArea& area) {
    area.setMinimumHeight(area.fontMetrics().height() * kLowestPages);
}

/// Makes each page scroll by itself if it does not fit, while the motions stay where they are.
void letScroll(QTabWidget& pages) {
    for (int i = 0; i < pages.count(); ++i) {
        QWidget* page = pages.widget(i);
        const QString title = pages.tabText(i);
        pages.removeTab(i);
        QScrollArea* area = scrolled(page);
        giveWay(*area);
        pages.insertTab(i, area, title);
    }
    pages.setCurrentIndex(0);
}

void letWrap(const QWidget& page, bool may) {
    // QLabel::setWordWrap() invalidates the layout even when nothing changes, so only changes are passed on.
    for (QLabel* label : page.findChildren<QLabel*>())
        if (label->buddy() != nullptr && label->wordWrap() != may)
            label->setWordWrap(may);
    FoldingGrid::letFold(page, may);
}

}  // namespace

ModulePage::ModulePage(const PanelView& view, Requests& requests) : m_context(view, requests, this) {
    // The palette of the window: otherwise, everything on the page would change its palette each time the
    // page appears or disappears.
    look::adoptReadable(this);
}

void ModulePage::layOut(QWidget* head, QLayout* motions, QTabWidget* pages) {
    m_pages = pages;
    letScroll(*pages);
    pages->setDocumentMode(true);
    pages->tabBar()->setAccessibleName(pages->accessibleName());
    pages->tabBar()->setObjectName(pages->objectName() + u"Bar"_s);
    keepFocusOnTabs(*pages);
    m_pageList = form::newChoice({.name = pages->objectName() + u"List"_s,
                                  .accessible = pages->accessibleName(),
                                  .meaning = tr("The pages of this module.")},
                                 this);
    m_pageList->hide();
    connect(m_pageList, &QComboBox::activated, pages, &QTabWidget::setCurrentIndex);
    connect(pages, &QTabWidget::currentChanged, m_pageList, &QComboBox::setCurrentIndex);
    const int unit = look::gridUnit(this);
    auto* left = new QWidget;
    motions->setContentsMargins(0, 0, 0, unit);
    left->setLayout(motions);
    m_motions = scrolled(left, u"panelScroll"_s, tr("Motions of the selected module"));
    giveWay(*m_motions);
    m_columnWidth = left->minimumSizeHint().width() + scrollBarWidth();
    m_columnWish = left->sizeHint().width() + scrollBarWidth();
    m_columns = new QHBoxLayout;
    m_columns->setContentsMargins(unit, 0, unit, 0);
    m_columns->setSpacing(unit);
    m_columns->addWidget(m_motions, 1);
    m_columns->addLayout(form::newColumn(this, {m_pageList, {pages, 1}}, 0.5), 1);
    auto* heading = new QHBoxLayout;
    heading->setContentsMargins(unit, unit / 2, unit, unit / 2);
    heading->addWidget(head);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addLayout(heading);
    layout->addLayout(m_columns, 1);
    connect(&m_context, &ModuleContext::changed, this, &ModulePage::lockPages);
    lockPages();
    // The box of a command that acts is shown, whatever triggered the command.
    for (Command* command : commands())
        connect(command, &QAction::triggered, this, [this, command] { reveal(*command->box()); });
}

void ModulePage::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        look::adoptReadable(this);
}

void ModulePage::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    if (m_pagesWish == 0)
        for (const QScrollArea* page : m_pages->findChildren<QScrollArea*>())
            m_pagesWish = qMax(m_pagesWish, page->widget()->minimumSizeHint().width() + scrollBarWidth());
    const bool narrow = width() < m_columnWidth + fontMetrics().height() * kNarrowestPages;
    if (!narrow)
        m_motions->setFixedWidth(motionsWidth());
    if (narrow == m_narrow)
        return fit(pageWidth());
    m_narrow = narrow;
    if (narrow) {
        // As a page it scrolls in both directions, because a button that is cut off cannot be reached.
        m_motions->setMinimumWidth(0);
        m_motions->setMaximumWidth(QWIDGETSIZE_MAX);
        m_pages->insertTab(0, m_motions, Common::tr("Motion"));
        m_pages->setCurrentIndex(0);
        if (m_tuning)
            revealTuning();
    } else {
        m_pages->removeTab(0);
        letWrap(*m_motions->widget(), false);
        m_columns->insertWidget(0, m_motions, 1);
        m_motions->show();
    }
    fit(pageWidth());
}

/// A list of the pages replaces their tabs if these do not fit, instead of arrows that hide some of them.
void ModulePage::offerPages() {
    const bool list = m_pages->tabBar()->sizeHint().width() > pageWidth() + scrollBarWidth();
    m_pages->tabBar()->setVisible(!list);
    m_pageList->setVisible(list);
    m_pageList->clear();
    for (int i = 0; i < m_pages->count(); ++i)
        m_pageList->addItem(m_pages->tabText(i).replace(u"&&"_s, u"&"_s));
    m_pageList->setCurrentIndex(m_pages->currentIndex());
}

/// Labels of fields wrap before a page scrolls sideways, and rows fold if that is not enough. Labels may not
/// wrap earlier, because a label that may wrap does so even if there is room.
void ModulePage::fit(int width) {
    offerPages();
    for (StagedForm* form : m_pages->findChildren<StagedForm*>())
        form->fitInto(width);
    for (int i = 0; i < m_pages->count(); ++i) {
        const auto* area = qobject_cast<QScrollArea*>(m_pages->widget(i));
        if (area == nullptr)
            continue;
        QWidget* page = area->widget();
        // At first, every label is on one line.
        const auto [need, first] = m_needs.try_emplace(page);
        if (first)
            need->second = page->minimumSizeHint().width();
        const bool wraps = width < need->second;
        letWrap(*page, wraps);
    }
}

int ModulePage::columnsWidth() const {
    return width() - m_columns->contentsMargins().left() - m_columns->contentsMargins().right();
}

int ModulePage::scrollBarWidth() const {
    return m_motions->verticalScrollBar()->sizeHint().width();
}

/// Half of the room, or more if the motions need it and the pages do not.
int ModulePage::motionsWidth() const {
    const int room = columnsWidth() - m_columns->spacing();
    return std::max({room / 2, m_columnWidth, std::min(m_columnWish, room - m_pagesWish)});
}

int ModulePage::pageWidth() const {
    const int beside = m_narrow ? 0 : motionsWidth() + m_columns->spacing();
    return columnsWidth() - beside - scrollBarWidth();
}

void ModulePage::setTuning(bool on) {
    if (std::exchange(m_tuning, on) != on && on)
        revealTuning();
}

void ModulePage::dropScrollBar() {
    if (spareHeight() < 0 || !m_motions->verticalScrollBar()->isVisible())
        return;
    m_motions->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_motions->setVerticalScrollBarPolicy(Qt::ScrollBarAsNeeded);
}

int ModulePage::spareHeight() const {
    const QWidget& motions = *m_motions->widget();
    const QSize room = m_motions->maximumViewportSize();
    // Only heightForWidth() takes into account how many lines the flowing rows need.
    const int need = motions.hasHeightForWidth() ? motions.heightForWidth(room.width()) : 0;
    return room.height() - qMax(need, motions.minimumSizeHint().height());
}

QList<Command*> ModulePage::commands() const {
    return findChildren<Command*>();
}

void ModulePage::reveal(const QWidget& box) {
    for (int i = 0; i < m_pages->count(); ++i)
        if (m_pages->widget(i)->isAncestorOf(&box))
            m_pages->setCurrentIndex(i);
}

void ModulePage::lockPages() {
    constexpr OperatorRights kNothing{false, false, false, false, false, false};
    const ModuleState& module = m_context.state();
    const auto rights = module.otherType() ? std::optional(kNothing) : module.rights;
    if (m_lockedFor == rights)
        return;
    m_lockedFor = rights;
    const auto mayUse = [&rights](const QWidget& page) {
        if (page.findChild<const HomingBox*>() != nullptr)
            return rights->homing;
        if (page.findChild<const StepperIoBox*>() != nullptr ||
            page.findChild<const IoValuesBox*>() != nullptr)
            return rights->outputs;
        return page.findChild<const DetailsBox*>() != nullptr;
    };
    for (int i = 0; i < m_pages->count(); ++i)
        if (QWidget* page = m_pages->widget(i); page != m_motions)
            page->setEnabled(!rights || mayUse(*page));
}

HoldButton* ModulePage::holdButton(bool reverse) {
    const auto direction = reverse ? HoldButton::Direction::Reverse : HoldButton::Direction::Forward;
    for (HoldButton* button : findChildren<HoldButton*>())
        if (button->direction() == direction) {
            reveal(*button);
            m_motions->ensureWidgetVisible(button);
            return button;
        }
    return nullptr;
}

MoveByBox* ModulePage::moveByBox() {
    auto* box = findChild<MoveByBox*>();
    if (box != nullptr) {
        reveal(*box);
        m_motions->ensureWidgetVisible(box);
    }
    return box;
}

/// Does not set the focus, because the next press of Space would then be a command. Waits until the window is
/// active again, because that change hides tool tips.
void ModulePage::pointTo(QWidget& control) {
    QTimer::singleShot(kWindowChanges, &control, [&control] {
        for (QWidget* around = control.parentWidget(); around != nullptr; around = around->parentWidget())
            if (auto* area = qobject_cast<QScrollArea*>(around))
                area->ensureWidgetVisible(&control);
        QToolTip::showText(control.mapToGlobal(control.rect().center()), control.toolTip(), &control);
    });
}

void ModulePage::showCommand(const QString& name) {
    for (const Command* command : commands()) {
        if (command->button()->objectName() != name)
            continue;
        reveal(*command->box());
        pointTo(*command->button());
    }
}

}  // namespace nmc
