// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/modulepanel.h"

#include <QEvent>
#include <QLabel>
#include <QScrollArea>
#include <utility>

#include "widgets/common/accessibility.h"
#include "widgets/common/form.h"
#include "widgets/common/look.h"
#include "widgets/common/scrolled.h"
#include "widgets/panels/genericpanel.h"
#include "widgets/panels/iopanel.h"
#include "widgets/panels/servopanel.h"
#include "widgets/panels/stepperpanel.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
constexpr int kNarrowestPage = 19;  ///< in heights of a text line

/// Puts a page that is built late at its place in the tab order, rather than at the end.
void keepTabOrder(QWidget* before, QWidget* page) {
    QList<QWidget*> controls;
    for (QWidget* next = page->nextInFocusChain(); next != page; next = next->nextInFocusChain())
        if (page->isAncestorOf(next))
            controls.append(next);
    for (QWidget* control : controls) {
        QWidget::setTabOrder(before, control);
        before = control;
    }
}
}  // namespace

ModulePanel::ModulePanel(Requests& requests, QWidget* parent)
    : QWidget(parent),
      m_requests(requests),
      m_empty(form::newRemark({}, this, u"emptyPanel"_s)),
      m_generic(new GenericPanel(requests, this)),
      m_current(m_empty) {
    look::name(this, u"modulePanel"_s, tr("Selected module"));
    m_empty->setAlignment(Qt::AlignCenter);
    m_generic->hide();
}

ModulePanel::~ModulePanel() {
    m_current = m_empty;
}

std::unique_ptr<ModulePage> ModulePanel::build(const PanelView& view) {
    std::unique_ptr<ModulePage> page;
    if (view.module.isServo())
        page = std::make_unique<ServoPanel>(view, m_requests);
    else if (view.module.isIo())
        page = std::make_unique<IoPanel>(view, m_requests);
    else
        page = std::make_unique<StepperPanel>(view, m_requests);
    connect(&page->context(), &ModuleContext::changed, this, [this, at = page.get()] {
        if (at == m_current)
            accessibility::setBusy(*this, at->context().busy());
    });
    connect(page.get(), &ModulePage::responseWanted, this, &ModulePanel::responseWanted);
    page->setTuning(m_foot != nullptr);
    return page;
}

void ModulePanel::dropReplaced(const bus::ModuleInfo& info) {
    const auto page = m_pages.find(info.index);
    if (page == m_pages.end() || info.identity == kUnheardModule ||
        (page->second.address == info.address && page->second.identity == info.identity))
        return;
    if (page->second.widget.get() == m_current)
        bringUp(m_empty);
    m_pages.erase(page);
}

ModulePage& ModulePanel::pageOf(const PanelView& view) {
    const bus::ModuleInfo& info = view.module.info;
    dropReplaced(info);  // before the new one is built, so that no request comes from both
    Page& page = m_pages[info.index];
    if (page.widget == nullptr)
        page = {info.address, info.identity, build(view)};
    return *page.widget;
}

bool ModulePanel::prepare(const PanelView& view) {
    if (!view.module.isKnown() || m_pages.count(view.module.info.index) != 0)
        return false;
    ModulePage& page = pageOf(view);
    page.resize(size());
    (void)page.grab({0, 0, 1, 1});  // this also determines fonts, sizes and positions
    return true;
}

void ModulePanel::keepUpToDate(const PanelView& view) {
    const auto page = m_pages.find(view.module.info.index);
    if (page != m_pages.end() && page->second.widget.get() != m_current)
        page->second.widget->context().show(view);
}

ModulePage* ModulePanel::page() const {
    return qobject_cast<ModulePage*>(m_current);
}

const ModulePage* ModulePanel::pageLike(const PanelView& view) {
    if (!view.module.isKnown())
        return nullptr;
    for (const auto& [module, page] : m_pages)
        if (page.identity == view.module.info.identity)
            return page.widget.get();
    return &pageOf(view);
}

void ModulePanel::forgetModules() {
    showNothing(m_empty->text());
    m_pages.clear();
}

void ModulePanel::resetSpeeds() {
    for (const auto& [module, page] : m_pages)
        emit page.widget->context().lookedForAnew();
}

void ModulePanel::endHold() {
    for (const auto& [module, page] : m_pages)
        emit page.widget->context().holdMustEnd();
}

void ModulePanel::stageGains(const servo::SetGain& gains) {
    if (auto* servo = qobject_cast<ServoPanel*>(m_current))
        servo->stageGains(gains);
}

void ModulePanel::bringUp(QWidget* page) {
    if (page == m_current)
        return;
    QWidget* before = std::exchange(m_current, page);
    // Qt would pass the focus of the page that is hidden to the first control of the other one, which is
    // Enable.
    if (QWidget* focused = window()->focusWidget(); focused != nullptr && isAncestorOf(focused))
        focused->clearFocus();
    if (page->parentWidget() != this) {
        page->setParent(this);
        keepTabOrder(m_generic, page);
    }
    fill();
    page->show();
    before->hide();
    if (qobject_cast<ModulePage*>(before) != nullptr)
        before->setParent(nullptr);
    emit pageChanged();
}

void ModulePanel::setFoot(QWidget* foot) {
    if (m_foot == foot)
        return;
    if (m_footPlace != nullptr) {
        (void)m_footPlace->takeWidget();
        m_footPlace->deleteLater();
        m_footPlace = nullptr;
    }
    if (m_foot)
        m_foot->removeEventFilter(this);
    m_foot = foot;
    if (foot != nullptr) {
        m_footPlace = scrolled(foot);
        m_footPlace->setParent(this);
        m_footPlace->show();
        foot->installEventFilter(this);
    }
    fill();
    for (const auto& [module, page] : m_pages)
        page.widget->setTuning(foot != nullptr);
}

void ModulePanel::fill() {
    QRect place = rect();
    if (m_footPlace != nullptr && m_foot) {
        const int foot = qMin(m_foot->sizeHint().height(), height() / 2);
        m_footPlace->setGeometry(0, height() - foot, width(), foot);
        place.setHeight(height() - foot);
    }
    m_current->setGeometry(place);
    // Never wider because of what a module reports: the list beside it would shrink, and every button would
    // move.
    const QSize least =
        m_current->minimumSizeHint().boundedTo({fontMetrics().height() * kNarrowestPage, QWIDGETSIZE_MAX});
    if (std::exchange(m_least, least) != least)
        updateGeometry();
}

bool ModulePanel::event(QEvent* event) {
    if (event->type() == QEvent::LayoutRequest)
        fill();
    return QWidget::event(event);
}

/// The foot may need another height.
bool ModulePanel::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_foot && event->type() == QEvent::LayoutRequest)
        fill();
    return QWidget::eventFilter(watched, event);
}

void ModulePanel::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    fill();
}

void ModulePanel::showModule(const PanelView& view) {
    if (!view.module.isKnown()) {
        endHold();
        accessibility::setBusy(*this, false);
        m_generic->showModule(view);
        bringUp(m_generic);
        return;
    }
    ModulePage& page = pageOf(view);
    page.showModule(view);
    accessibility::setBusy(*this, page.context().busy());
    // A hold on the previous page ends when that page is hidden.
    bringUp(&page);
}

void ModulePanel::showNothing(const QString& text, bool waiting) {
    endHold();
    accessibility::setBusy(*this, waiting);
    look::setText(m_empty, text);
    bringUp(m_empty);
}

void ModulePanel::showInstead(QWidget& page) {
    endHold();
    accessibility::setBusy(*this, false);
    bringUp(&page);
}

}  // namespace nmc
