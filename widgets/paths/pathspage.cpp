// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/paths/pathspage.h"

#include <QComboBox>
#include <QFileInfo>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <algorithm>
#include <utility>

#include "model/intent/backlash.h"
#include "model/intent/rights.h"
#include "model/intent/travel.h"
#include "model/module/modulescale.h"
#include "model/path/pathdrawing.h"
#include "model/sequence/sequencecheck.h"
#include "widgets/common/askdialog.h"
#include "widgets/common/form.h"
#include "widgets/common/look.h"
#include "widgets/common/pathtexts.h"
#include "widgets/common/requests.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/texts.h"
#include "widgets/common/words.h"
#include "widgets/panels/command.h"
#include "widgets/paths/pathplot.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
/// Steps of the progress bar: enough for any width.
constexpr int kWhole = 1'000;
}  // namespace

struct PathsPage::Basis {
    struct Axis {
        std::optional<Refusal> refusal;
        std::optional<std::int32_t> place;
        std::optional<PathControl> control;
        std::optional<servo::SetGain> gains;
        std::optional<TravelRange> travel;
        double fastest;
        std::optional<bus::GroupPlace> group;
        bool operator==(const Axis&) const = default;
    };
    std::shared_ptr<const LoadedPath> path;
    std::uint32_t baud;
    Duration latency;
    std::vector<Axis> axes{};
    bool operator==(const Basis&) const = default;
};

PathsPage::PathsPage(Requests& requests, QWidget* parent) : QWidget(parent), m_requests(requests) {
    look::name(this, u"pathsPage"_s, tr("Paths"));
    m_plot = new PathPlot(this);
    auto* left = form::newColumn(this, {buildChoice(), buildRun(), nullptr});
    form::fill(this, form::newLine(this, {{left, 2}, {m_plot, 3}}), 0.5);
    refresh();
}

PathsPage::~PathsPage() = default;

QWidget* PathsPage::buildChoice() {
    auto* box = new QWidget(this);
    look::name(box, u"pathChoice"_s, tr("Choice of a path"));
    m_open = new Command({.name = u"openPathButton"_s,
                          .text = tr("Open path…"),
                          .accessible = tr("Open path… from a CSV file")},
                         box, [this] { chooseFile(); });
    m_save = new Command(
        {.name = u"savePathButton"_s, .text = tr("Save path…"), .accessible = tr("Save path… as a CSV file")},
        box, [this] { chooseTarget(); });
    m_sequence = form::newChoice({u"pathSequenceBox"_s, tr("Sequence to draw a path from"), {}}, box);
    m_sequence->setMinimumContentsLength(10);
    m_rate = form::newChoice({u"pathRateBox"_s, tr("Rate of the path to draw"), {}}, box);
    for (const auto rate : {servo::PathRate::Hz30, servo::PathRate::Hz60, servo::PathRate::Hz120})
        m_rate->addItem(Common::tr("%1 Hz").arg(servo::nominalHertz(rate)), static_cast<int>(rate));
    m_rate->setCurrentIndex(1);
    m_draw = new Command({.name = u"drawPathButton"_s,
                          .icon = u"wand"_s,
                          .text = tr("Draw path"),
                          .accessible = tr("Draw path from the moves of a sequence")},
                         box, [this] { draw(); });
    m_summary = form::newParagraph(u"pathSummary"_s, tr("The path"), box);
    auto* files = form::newLine(box, {m_open->button(), m_save->button(), nullptr}, form::kUsual);
    auto* drawing = form::newLine(box, {m_draw->button(), {m_sequence, 1}, m_rate}, form::kUsual);
    form::fill(box, form::newColumn(box, {files, drawing, m_summary}, form::kUsual));
    connect(m_sequence, &QComboBox::currentIndexChanged, this, &PathsPage::refresh);
    return box;
}

QWidget* PathsPage::buildRun() {
    auto* box = new QWidget(this);
    look::name(box, u"pathRun"_s, tr("Running the path"));
    m_toStart = new Command({.name = u"pathToStartButton"_s,
                             .icon = u"arrow-bar-to-right"_s,
                             .text = tr("Move to start"),
                             .accessible = tr("Move to start: to the first point of the path")},
                            box, [this] { emit m_requests.goToPlace(start()); });
    m_run = new Command({.name = u"runPathButton"_s,
                         .icon = u"player-play"_s,
                         .text = tr("Run path"),
                         .accessible = tr("Run path, with confirmation")},
                        box, [this] { ask(); });
    m_end = new Command(
        {.name = u"endPathButton"_s,
         .icon = u"player-stop"_s,
         .text = tr("Stop path"),
         .accessible = tr("Stop path: all its axes slow down")},
        box, [this] { emit m_requests.intent(m_path->axes.front().module, intent::CancelProcedure{}); });
    m_progress = new QProgressBar(box);
    look::name(m_progress, u"pathProgress"_s, tr("Progress of the path"));
    m_progress->setRange(0, kWhole);
    m_state = form::newParagraph(u"pathState"_s, tr("State of the path"), box, 3);
    auto* buttons =
        form::newLine(box, {m_toStart->button(), m_run->button(), m_end->button(), nullptr}, form::kUsual);
    form::fill(box, form::newColumn(box, {buttons, m_progress, m_state}, form::kUsual));
    return box;
}

// ---- chain and path ----

AxisScale PathsPage::scaleOf(ModuleIndex module) const {
    const AxisSettings& axis = m_machine.axis(module);
    return nmc::scaleOf(moduleAt(module, m_link.modules), axis, axis.expected);
}

std::vector<PathColumn> PathsPage::axesNow() const {
    std::vector<PathColumn> axes;
    for (const ModuleState& module : m_link.modules)
        if (hasPathBuffer(module.info.identity)) {
            const ModuleIndex index = module.info.index;
            axes.push_back(pathColumn(pathName(index, m_machine.axis(index).name), module, scaleOf(index)));
        }
    nameApart(axes);
    return axes;
}

/// In another unit, or from another origin, the same counts would be other positions.
QString PathsPage::whyOutdated() const {
    for (std::size_t i = 0; i < m_path->axes.size(); ++i) {
        const PathColumn& axis = m_path->axes[i];
        const ModuleState* module = moduleAt(axis.module, m_link.modules);
        if (module == nullptr || !hasPathBuffer(module->info.identity) ||
            m_machine.axis(axis.module).unit != axis.scale.unit())
            return tr("The unit of an axis has changed. Open or draw the path again.");
        if (!m_path->origins.empty() && module->home.origin() != m_path->origins[i])
            return tr("The counter or the home of an axis has changed. Draw the path again.");
    }
    return {};
}

const ProcedureReport* PathsPage::report() const {
    if (!m_path)
        return nullptr;
    const auto found = m_procedures.find(m_path->axes.front().module);
    return found != m_procedures.end() && found->second.kind == ProcedureKind::FollowPath ? &found->second
                                                                                          : nullptr;
}

bool PathsPage::running() const {
    return report() != nullptr && !report()->over();
}

/// A path may have very many points, so they are checked only if the result may have changed.
void PathsPage::lookForObstacles() {
    Basis basis{m_path, m_link.baud, m_link.latency};
    for (const ModuleState& module : m_link.modules)
        basis.axes.push_back({nmc::whyNot(IntentKind::Move, module), module.commandPosition(),
                              module.pathControl, module.gains, travelRange(module), module.travel.fastest,
                              module.info.group});
    if (m_basis && *m_basis == basis)
        return;
    const auto plan = planPath(m_path->table, m_link.modules, {m_link.baud, m_link.latency});
    m_obstacle = plan ? std::nullopt : std::optional(plan.error());
    m_basis = std::make_unique<Basis>(std::move(basis));
}

QString PathsPage::whyNoAxes() const {
    if (const auto refusal = whyNoChain(m_link))
        return texts::refusal(*refusal);
    if (std::ranges::none_of(m_link.modules,
                             [](const ModuleState& module) { return hasPathBuffer(module.info.identity); }))
        return tr("Paths need a PIC-SERVO CMC or SC. This chain has none.");
    return running() ? tr("A path is running.") : QString();
}

QString PathsPage::whyNotMoved() const {
    if (const QString reason = whyNoAxes(); !reason.isEmpty())
        return reason;
    if (m_reading)  // what arrives takes the place of this path
        return tr("Reading the file…");
    if (!m_path)
        return tr("Open or draw a path first.");
    if (m_sequenceRuns)
        return tr("A sequence or a move to a point is running.");
    return whyOutdated();
}

QString PathsPage::whyNotRun() const {
    const QString reason = whyNotMoved();
    return reason.isEmpty() ? obstacleText() : reason;
}

QString PathsPage::obstacleText() const {
    return m_obstacle ? texts::pathObstacle(*m_obstacle, m_path->table.rate,
                                            [this](ModuleIndex module) { return scaleOf(module); })
                      : QString();
}

// ---- display ----

void PathsPage::showSession(const LinkState& link, const Machine& machine,
                            const Session::Procedures& procedures) {
    const bool others = m_machine.program.sequences != machine.program.sequences;
    m_link = link;
    m_machine = machine;
    m_procedures = procedures;
    if (link.connection != m_connection) {
        m_problems.clear();
        if (std::exchange(m_path, nullptr))
            m_plot->showNothing();
    }
    if (others)
        refreshSequences();
    refresh();
}

void PathsPage::showPath(LoadedPath path) {
    m_reading = false;
    if (m_connection != m_link.connection)
        return refresh();
    m_problems.clear();
    m_ran = false;
    m_path = std::make_shared<const LoadedPath>(std::move(path));
    m_about = {texts::pathLength(m_path->table)};
    for (std::size_t i = 0; i < m_path->axes.size(); ++i)
        m_about << texts::pathReach(m_path->table.columns[i], m_path->axes[i]);
    m_plot->showPath(m_path->table, m_path->axes);
    refresh();
}

void PathsPage::showProblems(const QString& name, const std::vector<PathProblem>& problems,
                             const std::vector<PathColumn>& axes) {
    m_reading = false;
    if (m_connection != m_link.connection)
        return refresh();
    QStringList lines{tr("%1 is not a path for this chain:").arg(name)};
    for (const PathProblem& problem : problems)
        lines << texts::pathProblem(problem, axes);
    if (problems.size() >= kMaxPathProblems)
        lines << tr("There may be more problems after these.");
    m_problems = lines.join(u'\n');
    refresh();
}

void PathsPage::showNotRead(const FileError& error) {
    m_reading = false;
    if (m_connection == m_link.connection)
        m_problems = texts::pathNotRead(error);
    refresh();
}

void PathsPage::showSequence(bool running) {
    m_sequenceRuns = running;
    refresh();
}

void PathsPage::showReading() {
    m_reading = true;
    m_connection = m_link.connection;
    refresh();
}

void PathsPage::refreshSequences() {
    const QString chosen = m_sequence->currentText();
    const QSignalBlocker blocker(m_sequence);
    m_sequence->clear();
    for (const Sequence& sequence : m_machine.program.sequences)
        m_sequence->addItem(QString::fromStdString(sequence.name));
    m_sequence->setCurrentIndex(std::max(0, m_sequence->findText(chosen)));
}

void PathsPage::refresh() {
    const QString noAxes = m_reading ? tr("Reading the file…") : whyNoAxes();
    m_open->setPossible(noAxes, tr("Reads positions for each point from a CSV file. Nothing moves."));
    m_save->setPossible(m_path ? QString() : tr("Open or draw a path first."),
                        tr("Saves the path as CSV, with its positions in the units of the axes."));
    m_draw->setPossible(!noAxes.isEmpty()          ? noAxes
                        : m_sequence->count() == 0 ? tr("Create a sequence of moves first (F3).")
                                                   : QString(),
                        tr("Turns the moves of this sequence into one motion without stops. Nothing moves."));
    const QString notMoved = whyNotMoved();
    if (notMoved.isEmpty())
        lookForObstacles();
    const QString notRun = notMoved.isEmpty() ? obstacleText() : notMoved;
    m_toStart->setPossible(notMoved.isEmpty() ? whyNotToStart() : notMoved,
                           tr("Moves each axis of the path to its first point."));
    m_run->setPossible(notRun, tr("Runs all axes through the path. Asks first."));
    m_end->setPossible(running() ? QString() : tr("No path is running."),
                       tr("Stops all axes of the path; they hold where they stop."));
    QStringList summary;
    if (!m_problems.isEmpty())
        summary << m_problems;
    if (m_path) {
        summary << Common::tr("%1: %2").arg(m_path->name, m_about.join(u'\n'));
    } else if (m_problems.isEmpty() && whyNoAxes().isEmpty()) {
        QStringList names;
        for (const PathColumn& axis : axesNow())
            names << QString::fromStdString(axis.name);
        summary << tr("A path file has a column for each axis. Axes here: %1.").arg(names.join(u", "_s));
    }
    look::setText(m_summary, summary.join(u'\n'));
    refreshProgress(notRun);
    AskDialog::reviewAll(*this);
}

void PathsPage::refreshProgress(const QString& notRun) {
    m_ran = m_ran || running();
    const bool ofThis = m_ran && report() != nullptr;
    const auto& path = ofThis ? report()->path : std::nullopt;
    const double share =
        path ? static_cast<double>(path->done) / static_cast<double>(std::max<std::size_t>(1, path->points()))
             : 0.0;
    m_progress->setValue(qRound(share * kWhole));
    m_plot->showProgress(ofThis ? share : -1.0);
    const QString state = ofThis ? texts::pathState(*report()) : QString();
    look::setText(m_state,
                  running() || notRun.isEmpty() ? state : QStringList{state, notRun}.join(u'\n').trimmed());
}

// ---- actions of the user ----

void PathsPage::chooseFile() {
    askWhatToOpen(this,
                  {.objectName = u"openPathDialog"_s,
                   .title = tr("Open a path"),
                   .filters = {Common::tr("CSV (*.csv)"), Common::tr("All files (*)")}},
                  [this](const QString& file) {
                      if (whyNoAxes().isEmpty())
                          emit m_requests.openPath(file, axesNow());
                  });
}

void PathsPage::chooseTarget() {
    askWhereToSave(this,
                   {.objectName = u"savePathDialog"_s,
                    .title = tr("Save the path"),
                    .filters = {Common::tr("CSV (*.csv)")},
                    .proposed = QFileInfo(m_path->name).completeBaseName()},
                   [this, path = m_path](const QString& file) {
                       emit m_requests.save(file, [path] { return pathText(path->table, path->axes); });
                   });
}

void PathsPage::draw() {
    const std::string sequence = m_sequence->currentText().toStdString();
    std::vector<ModuleState> modules = asOfSequence(m_link.modules);
    for (ModuleState& module : modules)
        module = withoutBacklash(std::move(module));  // a path goes straight to its points
    const auto refused = nmc::whyNotRun(sequence, 0, m_machine, modules);
    if (!refused.empty()) {
        m_problems = texts::sequenceProblem(refused.front());
        return refresh();
    }
    auto table = drawPath(sequence, m_machine, m_link.modules,
                          static_cast<servo::PathRate>(m_rate->currentData().toInt()));
    if (!table) {
        m_problems = texts::drawingProblem(table.error());
        return refresh();
    }
    std::vector<PathColumn> axes = columnsOf(*table, axesNow());
    std::vector<HomeFact::Origin> origins;
    for (const PathColumn& axis : axes)
        origins.push_back(m_link.modules[axis.module.value()].home.origin());
    m_connection = m_link.connection;
    showPath({m_sequence->currentText(), std::move(*table), std::move(axes), std::move(origins)});
}

/// As a taught point: all rules for a move there apply, and a stop ends it.
Point PathsPage::start() const {
    Point place{.name = tr("Start of the path").toStdString(), .axes = {}};
    for (const PathTable::Column& column : m_path->table.columns) {
        const auto home = m_link.modules[column.module.value()].home.place();
        place.axes.push_back(
            {column.module, countsBetween(home ? home->counts : 0, column.points.front()), home.has_value()});
    }
    return place;
}

QString PathsPage::whyNotToStart() const {
    const Point place = start();
    const auto problems = nmc::whyNotRun(kMoveToPoint, 0, withMoveTo(withPlace(m_machine, place), place.name),
                                         asOfSequence(m_link.modules));
    return problems.empty() ? QString() : texts::sequenceProblem(problems.front());
}

/// Out of sight, the page is not kept up to date.
QString PathsPage::question() const {
    if (!isVisible() || !whyNotRun().isEmpty())
        return {};
    QStringList lines{tr("All axes of the path start to move. Make sure that nothing is in their way.")};
    return (lines + m_about).join(u'\n');
}

void PathsPage::ask() {
    AskDialog::ask({.name = u"runPathDialog"_s,
                    .title = tr("Run the path"),
                    .text = [this, path = m_path] { return path == m_path ? question() : QString(); },
                    .stayName = u"cancelPathButton"_s,
                    .textName = u"runPathText"_s},
                   {{tr("&Run path"), u"runPathGo"_s, [this] { run(); }}}, this, this);
}

/// Plans the path again, because the modules may have changed since the question was asked.
void PathsPage::run() {
    if (!whyNotRun().isEmpty())
        return;
    const auto plan = planPath(m_path->table, m_link.modules, {m_link.baud, m_link.latency});
    if (!plan)
        return refresh();
    emit m_requests.intent(m_path->axes.front().module, *plan);
}

}  // namespace nmc
