// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/simulator/simulatorbench.h"

#include <QComboBox>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QStackedWidget>

#include "widgets/common/form.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/words.h"
#include "widgets/simulator/benchtruth.h"
#include "widgets/simulator/controllinebox.h"
#include "widgets/simulator/modulebench.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {

constexpr int kPollMs = 200;
constexpr int kTicksPerStatistics = 5;
/// Ticks after which a query must have been lost with an earlier connection.
constexpr int kMaxWaits = 10;
/// Maximum number of typed lines that wait for an answer, in case it never comes.
constexpr int kMaxTyped = 64;
/// Has the size hint of its page; that of QScrollArea is never more than 24 lines.
class Page : public QScrollArea {
public:
    using QScrollArea::QScrollArea;
    [[nodiscard]] QSize sizeHint() const override { return widget()->sizeHint(); }
};

const QString kStatisticsQuestion = u"stats"_s;
const QString kStateQuestion = u"state "_s;

}  // namespace

SimulatorBench::SimulatorBench(QWidget* parent)
    : QWidget(parent),
      m_module(new QComboBox(this)),
      m_type(look::newMutedLabel({}, this)),
      m_benches(new QStackedWidget(this)),
      m_servo(new ModuleBench(ModuleType::Servo, this)),
      m_step(new ModuleBench(ModuleType::Stepper, this)),
      m_io(new ModuleBench(ModuleType::Io, this)),
      m_truth(new BenchTruth(this)),
      m_line(new ControlLineBox(this)) {
    look::name(this, u"simulatorBench"_s, Common::tr("Simulator"));
    buildContent();
    m_timer.setInterval(kPollMs);
    connect(&m_timer, &QTimer::timeout, this, &SimulatorBench::tick);
    connect(m_module, &QComboBox::currentIndexChanged, this, &SimulatorBench::chooseModule);
    for (const ModuleBench* bench : {m_servo, m_step, m_io})
        connect(bench, &ModuleBench::lineEntered, this, &SimulatorBench::change);
    connect(m_line, &ControlLineBox::lineEntered, this, [this](const QString& line) {
        m_typed.append(line);
        if (m_typed.size() > kMaxTyped)
            m_typed.removeFirst();
        change(line);
    });
}

void SimulatorBench::buildContent() {
    look::name(m_module, u"simModuleBox"_s, tr("Simulated module"));
    m_module->setToolTip(tr("Follows the module list, and includes modules that the panel did not find."));
    m_module->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    m_benches->addWidget(m_servo);
    m_benches->addWidget(m_step);
    m_benches->addWidget(m_io);
    const int unit = look::gridUnit(this);
    auto* choice = form::newLine(this, {m_module, {m_type, 1}}, form::kUsual);
    choice->setContentsMargins(unit, unit / 2, unit, 0);
    auto* page = new QWidget(this);
    form::fill(page, form::newColumn(page, {m_benches, m_truth, nullptr}, form::kUsual));
    auto* scroll = new Page(this);
    look::name(scroll, u"simScroll"_s, Common::tr("Simulator"));
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setWidget(page);
    scroll->setMinimumWidth(page->minimumSizeHint().width() + unit * 2);
    // The control line is always visible, because it also shows what else is refused.
    form::fill(this, form::newColumn(this, {choice, {scroll, 1}, m_line}, 0.5));
}

void SimulatorBench::begin() {
    m_followed.reset();
    m_typed.clear();
    m_polled.clear();
    m_truth->forget();
    m_line->forget();
}

void SimulatorBench::offerModules(int count) {
    setModules(std::max(m_module->count(), count));
}

void SimulatorBench::setModules(int count) {
    const bool others = count != m_module->count();
    const QSignalBlocker blocker(m_module);
    while (m_module->count() > count)
        m_module->removeItem(m_module->count() - 1);
    form::offerModules(m_module, 0, count);
    if (others)
        chooseModule();
}

void SimulatorBench::showSelected(std::optional<ModuleIndex> module) {
    if (module == m_followed || !module.has_value())
        return;
    m_followed = module;
    m_module->setCurrentIndex(module->value());
}

void SimulatorBench::chooseModule() {
    const int number = m_module->currentIndex() + 1;
    for (ModuleBench* bench : {m_servo, m_step, m_io})
        bench->setModule(number);
    m_polled.clear();
    if (isVisible())
        poll();
}

QString SimulatorBench::stateLine() const {
    return kStateQuestion + QString::number(m_module->currentIndex() + 1);
}

void SimulatorBench::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    m_timer.start();
}

void SimulatorBench::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    m_timer.stop();
}

void SimulatorBench::tick() {
    if (m_ticks++ % kTicksPerStatistics == 0)
        emit lineEntered(kStatisticsQuestion);
    if (m_polled.isEmpty() || ++m_waited > kMaxWaits)
        poll();
}

void SimulatorBench::poll() {
    if (m_module->currentIndex() < 0)
        return;
    m_polled = stateLine();
    m_outdated = false;
    m_waited = 0;
    emit lineEntered(m_polled);
}

void SimulatorBench::change(const QString& line) {
    m_outdated = true;
    emit lineEntered(line);
}

void SimulatorBench::showAnswer(const QString& line, const QByteArray& json) {
    const QJsonObject answer = QJsonDocument::fromJson(json).object();
    const bool typed = m_typed.removeOne(line);
    if (line == kStatisticsQuestion) {
        setModules(static_cast<int>(answer["modules"_L1].toArray().size()));
        m_truth->showStatistics(answer);
    } else if (line == m_polled) {
        m_polled.clear();
        showState(answer);
    }
    const bool question = line == kStatisticsQuestion || line.startsWith(kStateQuestion);
    if (typed || !question)
        m_line->showAnswer(line, json);
    if (!question && m_polled.isEmpty() && isVisible())
        poll();  // at once, so that the effect of a click is visible
}

void SimulatorBench::showState(const QJsonObject& state) {
    if (state.contains("error"_L1))
        return;
    m_truth->showState(state);
    const QString kind = state["type"_L1].toString();
    const ModuleType type = kind == "step"_L1 ? ModuleType::Stepper
                            : kind == "io"_L1 ? ModuleType::Io
                                              : ModuleType::Servo;
    look::setText(m_type, texts::moduleType({type, static_cast<std::uint8_t>(state["version"_L1].toInt())}));
    ModuleBench* bench = type == ModuleType::Stepper ? m_step : type == ModuleType::Io ? m_io : m_servo;
    m_benches->setCurrentWidget(bench);
    // A state that was requested before the latest change would undo it on the screen for a moment.
    if (!m_outdated)
        bench->showState(state);
}

}  // namespace nmc
