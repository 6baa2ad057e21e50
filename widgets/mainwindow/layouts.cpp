// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/mainwindow/layouts.h"

#include <QAction>
#include <QActionGroup>
#include <QLayout>
#include <QMainWindow>
#include <QSettings>
#include <algorithm>
#include <array>
#include <map>

#include "widgets/common/lazydock.h"
#include "widgets/common/look.h"
#include "widgets/mainwindow/settingskeys.h"

namespace nmc {

using namespace Qt::StringLiterals;
using namespace settingskeys;

namespace {

enum class Place : quint8 {
    Apart,   ///< beside the other docks of its area
    Below,   ///< below the previous dock of its area
    Behind,  ///< behind the tab of the previous dock of its area
};
using enum Place;

/// Where a dock is at first. Its size is a share of the window's; 0: what the others leave. A negative width
/// leaves so many lines of text to the rest of the window.
struct Cell {
    Qt::DockWidgetArea area;
    Place place = Apart;
    bool open = false;
    double width = 0;
    double height = 0;
};

struct Row {
    QLatin1String dock;
    Cell operate, tune, chain;
    /// The size that its content needs when the user opens it, in lines of text.
    QSize wanted{};

    [[nodiscard]] const Cell& cell(Layouts::Kind kind) const {
        return kind == Layouts::Kind::Tune ? tune : kind == Layouts::Kind::Chain ? chain : operate;
    }
};

constexpr auto kLeft = Qt::LeftDockWidgetArea;
constexpr auto kRight = Qt::RightDockWidgetArea;
constexpr auto kBottom = Qt::BottomDockWidgetArea;
constexpr bool kOpen = true;

// clang-format off
const std::array kRows{
    //                        Operate                               Tune                                 Chain
    Row{"chainDock"_L1,     {kLeft, Apart, kOpen, 0.15},          {kRight, Apart},                     {kLeft, Apart, kOpen, 0.15}},
    Row{"simulatorDock"_L1, {kLeft, Behind, kOpen},               {kRight, Apart},                     {kLeft, Behind, kOpen}},
    Row{"scopeDock"_L1,     {kBottom, Apart, kOpen, 0.56, 0.39},  {kLeft, Apart, kOpen, -22, 0.4},    {kBottom, Apart}},
    Row{"responseDock"_L1,  {kBottom, Behind},                    {kLeft, Below, kOpen, 0, 0.6},    {kBottom, Behind},    {58, 0}},
    Row{"loopTestsDock"_L1, {kBottom, Behind},                    {kLeft, Behind},                     {kBottom, Behind},    {58, 0}},
    Row{"sequencesDock"_L1, {kBottom, Behind},                    {kRight, Apart},                     {kBottom, Behind},    {62, 24}},
    Row{"pathsDock"_L1,     {kBottom, Behind},                    {kRight, Apart},                     {kBottom, Behind},    {52, 0}},
    Row{"axesDock"_L1,      {kBottom, Behind},                    {kRight, Apart},                     {kBottom, Behind}},
    Row{"messagesDock"_L1,  {kBottom, Apart, kOpen, 0.29},        {kRight, Apart},                     {kBottom, Apart, kOpen, 0.35}},
    Row{"monitorDock"_L1,   {kBottom, Behind},                    {kRight, Apart},                     {kBottom, Apart, kOpen, 0.5, 0.5}, {44, 0}},
};
// clang-format on

/// What a dock beside another keeps, in lines of text.
constexpr int kLeastWidth = 18;

const Row& rowOf(const QDockWidget& dock) {
    return *std::ranges::find_if(kRows, [&dock](const Row& row) { return row.dock == dock.objectName(); });
}

}  // namespace

Layouts::Layouts(QMainWindow& window, QSettings& settings)
    : QObject(&window), m_window(window), m_settings(settings) {
    auto* group = new QActionGroup(this);
    addAction(u"operateLayoutAction"_s, tr("&Operate"),
              tr("Motion in the middle, everything else around it."), Qt::CTRL | Qt::Key_1);
    addAction(u"tuneLayoutAction"_s, tr("&Tune"),
              tr("Large plots, with gains and step response beside them."), Qt::CTRL | Qt::Key_2);
    addAction(u"chainLayoutAction"_s, tr("&Chain"), tr("Modules, packets and messages."),
              Qt::CTRL | Qt::Key_3);
    for (QAction* action : m_actions)
        group->addAction(action);
}

void Layouts::addAction(const QString& objectName, const QString& text, const QString& meaning,
                        const QKeySequence& key) {
    const Kind kind = static_cast<Kind>(m_actions.size());
    QAction* action = look::newAction(this, objectName, text, meaning, key);
    action->setCheckable(true);
    connect(action, &QAction::triggered, this, [this, kind] { choose(kind); });
    m_actions.append(action);
}

void Layouts::add(QDockWidget& dock) {
    m_docks.append(&dock);
    // Queued: until then, the window does not know that the dock is visible.
    if (const auto* lazy = qobject_cast<LazyDock*>(&dock))
        connect(
            lazy, &LazyDock::roomWanted, this, [this, &dock] { makeRoomFor(dock); }, Qt::QueuedConnection);
    // The action changes before its dock is shown, and a dock is closed before it is hidden.
    connect(dock.toggleViewAction(), &QAction::toggled, this, [this, &dock](bool on) {
        if (on && dock.isHidden())
            keepColumnBeside(dock);
    });
    dock.installEventFilter(this);
}

bool Layouts::eventFilter(QObject* watched, QEvent* event) {
    if (auto* dock = qobject_cast<QDockWidget*>(watched); dock != nullptr && event->type() == QEvent::Close)
        keepColumnBeside(*dock);
    return QObject::eventFilter(watched, event);
}

void Layouts::open(QDockWidget& dock) {
    if (dock.isHidden())
        keepColumnBeside(dock);
    dock.show();
    dock.raise();
}

void Layouts::keepColumnBeside(QDockWidget& dock) {
    if (m_window.layout() == nullptr || m_window.dockWidgetArea(&dock) != kRight)
        return;
    const auto keep = [this, column = m_window.centralWidget()->width()] {
        m_window.layout()->activate();
        keepColumn(m_window.centralWidget()->width() - column);
    };
    QMetaObject::invokeMethod(this, keep, Qt::QueuedConnection);
}

QDockWidget& Layouts::dock(const QString& objectName) const {
    return *m_window.findChild<QDockWidget*>(objectName);
}

/// The first layout has the keys that existed before the others were added.
QString Layouts::key(const QString& setting) const {
    switch (m_kind) {
        case Kind::Operate:
            break;
        case Kind::Tune:
            return setting + u"/tune"_s;
        case Kind::Chain:
            return setting + u"/chain"_s;
    }
    return setting;
}

bool Layouts::opens(const QDockWidget& dock) const {
    return rowOf(dock).cell(m_kind).open;
}

void Layouts::restore() {
    const int kept = m_settings.value(kLayout).toInt();
    m_kind = static_cast<Kind>(qBound(0, kept, static_cast<int>(m_actions.size()) - 1));
    show();
}

void Layouts::show() {
    m_actions[static_cast<int>(m_kind)]->setChecked(true);
    if (!m_window.restoreState(m_settings.value(key(kState)).toByteArray()))
        arrange();
    emit chosen(m_kind);
}

void Layouts::save() {
    m_settings.setValue(key(kState), m_window.saveState());
    m_settings.setValue(kLayout, static_cast<int>(m_kind));
}

void Layouts::choose(Kind kind) {
    if (kind == m_kind)
        return;
    save();
    m_kind = kind;
    show();
}

void Layouts::reset() {
    arrange();
    emit chosen(m_kind);
}

/// Puts the docks where the table has them.
void Layouts::arrange() {
    for (QDockWidget* dock : m_docks) {
        dock->setFloating(false);
        m_window.removeDockWidget(dock);
    }
    std::map<Qt::DockWidgetArea, QDockWidget*> previous;
    for (const Row& row : kRows) {
        const Cell& cell = row.cell(m_kind);
        QDockWidget& next = dock(row.dock);
        m_window.addDockWidget(cell.area, &next);
        if (cell.place == Below)
            m_window.splitDockWidget(previous.at(cell.area), &next, Qt::Vertical);
        else if (cell.place == Behind)
            m_window.tabifyDockWidget(previous.at(cell.area), &next);
        next.setVisible(cell.open);
        previous[cell.area] = &next;
    }
    // Last, because whatever is added undoes it.
    for (const Qt::Orientation orientation : {Qt::Horizontal, Qt::Vertical}) {
        QList<QDockWidget*> docks;
        QList<int> sizes;
        for (const Row& row : kRows) {
            const Cell& cell = row.cell(m_kind);
            const bool across = orientation == Qt::Horizontal;
            const double share = across ? cell.width : cell.height;
            const int whole = across ? m_window.width() : m_window.height();
            if (share == 0)
                continue;
            docks << &dock(row.dock);
            sizes << (share > 0 ? qRound(share * whole)
                                : qMax(1, whole + qRound(share) * m_window.fontMetrics().height()));
        }
        m_window.resizeDocks(docks, sizes, orientation);
    }
}

void Layouts::keepColumn(int wider) {
    QDockWidget& scope = dock(u"scopeDock"_s);
    if (m_kind == Kind::Tune && m_window.dockWidgetArea(&scope) == kLeft && scope.isVisible())
        m_window.resizeDocks({&scope}, {qMax(1, scope.width() + wider)}, Qt::Horizontal);
}

/// The dock that shares the width of the window's lower part with this one; null: none.
QDockWidget* Layouts::beside(QDockWidget& dock) const {
    if (m_window.dockWidgetArea(&dock) != kBottom)
        return nullptr;
    const auto found = std::ranges::find_if(m_docks, [&](QDockWidget* other) {
        return other != &dock && !other->isFloating() && !other->visibleRegion().isEmpty() &&
               m_window.dockWidgetArea(other) == kBottom && other->y() == dock.y();
    });
    return found != m_docks.end() ? *found : nullptr;
}

/// Widens a dock that the user has opened at the expense of the one beside it, and makes it high enough.
void Layouts::makeRoomFor(QDockWidget& dock) {
    const int line = m_window.fontMetrics().height();
    const QSize wanted = rowOf(dock).wanted * line;
    if (QDockWidget* other = beside(dock); other != nullptr && dock.width() < wanted.width()) {
        const int both = dock.width() + other->width();
        const int taken = qMin(wanted.width(), qMax(both / 2, both - line * kLeastWidth));
        m_window.resizeDocks({&dock, other}, {taken, both - taken}, Qt::Horizontal);
    }
    const int height = qMin(wanted.height(), m_window.height() / 2);
    if (m_window.dockWidgetArea(&dock) == kBottom && dock.height() < height)
        m_window.resizeDocks({&dock}, {height}, Qt::Vertical);
}

}  // namespace nmc
