// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/sequences/sequencespage.h"

#include <QComboBox>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QTableView>
#include <QToolTip>
#include <QUndoCommand>
#include <utility>

#include "model/intent/rights.h"
#include "model/module/modulescale.h"
#include "model/sequence/sequencecheck.h"
#include "model/sequence/sequenceedit.h"
#include "widgets/common/elidedlabel.h"
#include "widgets/common/flowlayout.h"
#include "widgets/common/form.h"
#include "widgets/common/look.h"
#include "widgets/common/requests.h"
#include "widgets/common/scrolled.h"
#include "widgets/common/sequencetexts.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/words.h"
#include "widgets/panels/command.h"
#include "widgets/sequences/pointsmodel.h"
#include "widgets/sequences/rowdelegate.h"
#include "widgets/sequences/rowsmodel.h"

namespace nmc {

using namespace Qt::StringLiterals;

/// All points and sequences before and after one change.
class SequencesPage::Edit : public QUndoCommand {
public:
    Edit(SequencesPage& page, const QString& what, Program before, Program now)
        : QUndoCommand(what), m_page(page), m_before(std::move(before)), m_now(std::move(now)) {}
    void undo() override { m_page.put(m_before); }
    void redo() override { m_page.put(m_now); }

private:
    SequencesPage& m_page;
    Program m_before;
    Program m_now;
};

namespace {

constexpr auto kEditTriggers =
    QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed | QAbstractItemView::AnyKeyPressed;

QTableView* newTable(QAbstractItemModel* model, const QString& objectName, const QString& name,
                     QWidget* parent) {
    auto* table = new QTableView(parent);
    look::name(table, objectName, name);
    table->setModel(model);
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->setSelectionMode(QAbstractItemView::SingleSelection);
    table->setTabKeyNavigation(false);
    table->setWordWrap(false);
    table->horizontalHeader()->setHighlightSections(false);
    table->horizontalHeader()->setStretchLastSection(true);
    table->verticalHeader()->setDefaultSectionSize(table->fontMetrics().height() * 3 / 2);
    return table;
}

template <typename... Commands>
QWidget* newRow(QWidget* box, Commands*... commands) {
    auto* row = new QWidget(box);
    auto* layout = new FlowLayout(look::gridUnit(box) / 2);
    layout->setContentsMargins(0, 0, 0, 0);
    (layout->addWidget(commands->button()), ...);
    row->setLayout(layout);
    return row;
}

}  // namespace

SequencesPage::SequencesPage(Requests& requests, QWidget* parent)
    : QWidget(parent), m_requests(requests), m_points(new PointsModel(this)), m_rows(new RowsModel(this)) {
    look::name(this, u"sequencesPage"_s, Common::tr("Points and sequences"));
    // Outside what scrolls, so that a run can be paused and stopped whatever is being looked at.
    QWidget* run = buildRun();
    auto* tables = new QWidget(this);
    tables->setLayout(form::newLine(tables, {{buildPoints(), 2}, {buildSequences(), 3}}, form::kUsual));
    auto* scroll = scrolled(tables, u"sequencesPageScroll"_s, accessibleName());
    // In a low dock, the tables give way, and not the second line of buttons.
    scroll->setMinimumHeight(fontMetrics().height() * 2);
    form::fill(this, form::newColumn(this, {run, {scroll, 1}}, 0));
    connect(m_points, &PointsModel::renameWanted, this,
            [this](const std::string& from, const std::string& to) {
                edit(tr("Rename point"), [&](Program& program) { renamePoint(program, from, to); });
            });
    connect(m_rows, &RowsModel::rowEdited, this, [this](int row, const Action& action) {
        editRows(tr("Change row"),
                 [&](Sequence& sequence) { sequence.rows[static_cast<std::size_t>(row)] = action; });
    });
    connect(&m_edits, &QUndoStack::indexChanged, this, &SequencesPage::refresh);
    refresh();
}

QWidget* SequencesPage::buildPoints() {
    auto* box = new QGroupBox(tr("Points"), this);
    look::name(box, u"pointsBox"_s, tr("Points"));
    m_pointTable = newTable(m_points, u"pointTable"_s, tr("Points"), box);
    m_pointTable->verticalHeader()->hide();
    m_pointName = form::newText(
        {u"pointNameField"_s, tr("Name of the point to teach"), 60, {}, tr("Name of a point")}, box);
    m_axes = new QListWidget(box);
    look::name(m_axes, u"teachAxesList"_s, tr("Axes to teach"));
    m_axes->setFlow(QListView::LeftToRight);
    m_axes->setWrapping(true);
    m_axes->setResizeMode(QListView::Adjust);
    m_axes->setMaximumHeight(m_axes->fontMetrics().height() * 4);
    m_axes->setToolTip(tr("The selected axes become part of the point."));
    m_teach = new Command({.name = u"teachButton"_s,
                           .icon = u"download"_s,
                           .text = tr("Teach"),
                           .accessible = tr("Teach a point: store the positions of the selected axes")},
                          box, [this] { teach(); });
    m_goTo = new Command({.name = u"goToPointButton"_s,
                          .icon = u"arrow-bar-to-right"_s,
                          .text = tr("Go to point"),
                          .accessible = tr("Go to point: the selected one")},
                         box, [this] {
                             if (const Point* point = chosenPoint())
                                 emit m_requests.goToPoint(point->name);
                         });
    m_removePoint =
        new Command({.name = u"removePointButton"_s,
                     .icon = u"x"_s,
                     .text = tr("Remove point"),
                     .accessible = tr("Remove point: the selected one")},
                    box, [this] {
                        if (const Point* point = chosenPoint())
                            edit(tr("Remove point"), [name = point->name](Program& program) {
                                std::erase_if(program.points, [&](const Point& p) { return p.name == name; });
                            });
                    });
    auto* motions = newRow(box, m_goTo, m_removePoint);
    auto* teaching = form::newLine(box, {{m_pointName, 1}, m_teach->button()}, form::kUsual);
    box->setLayout(form::newColumn(box, {{m_pointTable, 1}, motions, m_axes, teaching}, form::kUsual));
    connect(m_pointTable->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &SequencesPage::refreshPoints);
    connect(m_pointName, &QLineEdit::textChanged, this, &SequencesPage::refreshPoints);
    connect(m_pointName, &QLineEdit::returnPressed, this, [this] {
        if (!m_teach->isEnabled())
            QToolTip::showText(m_pointName->mapToGlobal(m_pointName->rect().bottomLeft()), m_teach->reason(),
                               m_pointName);
        m_teach->act();
    });
    connect(m_axes, &QListWidget::itemChanged, this, &SequencesPage::refreshPoints);
    return box;
}

QWidget* SequencesPage::buildSequences() {
    auto* box = new QGroupBox(tr("Sequences"), this);
    look::name(box, u"sequencesBox"_s, tr("Sequences"));
    m_sequenceName = form::newText({u"sequenceNameField"_s, tr("Name of the sequence"), 60}, box);
    m_newSequence = new Command(
        {.name = u"newSequenceButton"_s, .text = tr("New sequence"), .accessible = tr("New sequence")}, box,
        [this] {
            const std::string name = freeName(m_machine.program.sequences, tr("Sequence").toStdString());
            edit(tr("New sequence"), [&](Program& program) { program.sequences.push_back({name, {}}); });
            m_sequence->setCurrentText(QString::fromStdString(name));
        });
    m_removeSequence = new Command({.name = u"removeSequenceButton"_s,
                                    .icon = u"x"_s,
                                    .text = tr("Remove sequence"),
                                    .accessible = tr("Remove sequence with its rows")},
                                   box, [this] {
                                       edit(tr("Remove sequence"), [name = sequence()](Program& program) {
                                           std::erase_if(program.sequences,
                                                         [&](const Sequence& s) { return s.name == name; });
                                       });
                                   });
    m_rowTable = newTable(m_rows, u"rowTable"_s, tr("Rows of the sequence"), box);
    m_rowTable->setItemDelegate(new RowDelegate(this));
    // Reserves room for the mark of the running row, so that no column moves when the mark appears.
    QFont bold = m_rowTable->font();
    bold.setBold(true);
    m_rowTable->verticalHeader()->setMinimumWidth(QFontMetrics(bold).horizontalAdvance(u"▸ 100 "_s));
    m_foresight = form::newRemark({}, box, u"dryRunLabel"_s);
    m_foresight->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* result = new QScrollArea(box);
    look::name(result, u"dryRunArea"_s, tr("Result of the dry run"));
    result->setWidget(m_foresight);
    result->setWidgetResizable(true);
    result->setFrameShape(QFrame::NoFrame);
    // Empty or not, it takes the same room, so that no button moves under the pointer when a result appears.
    result->setFixedHeight(fontMetrics().height() * 4);
    m_foresight->setAlignment(Qt::AlignTop | Qt::AlignLeft);

    auto* head = form::newLine(
        box, {{m_sequenceName, 1}, m_newSequence->button(), m_removeSequence->button()}, form::kUsual);
    box->setLayout(form::newColumn(box, {head, {m_rowTable, 1}, buildRowButtons(box), result}, form::kUsual));
    connect(m_sequenceName, &QLineEdit::editingFinished, this, [this] {
        const std::string from = sequence();
        const std::string to = m_sequenceName->text().simplified().toStdString();
        if (from.empty() || to.empty() || from == to || m_machine.program.sequence(to) != nullptr)
            return m_sequenceName->setText(QString::fromStdString(from));
        edit(tr("Rename sequence"), [&](Program& program) { renameSequence(program, from, to); });
        m_sequence->setCurrentText(QString::fromStdString(to));
    });
    connect(m_rowTable->selectionModel(), &QItemSelectionModel::selectionChanged, this, [this] {
        refreshRows();
        refreshRun();
    });
    return box;
}

QWidget* SequencesPage::buildRowButtons(QGroupBox* box) {
    m_addRow = new Command(
        {u"addRowButton"_s, {}, tr("Add row"), tr("Add row after the selected one")}, box, [this] {
            const std::size_t at = chosenRow() ? *chosenRow() + 1 : m_rows->rows().size();
            editRows(tr("Add row"), [&](Sequence& sequence) { insertRow(sequence, at, m_rows->newRow()); });
            m_rowTable->selectRow(static_cast<int>(at));
        });
    m_duplicateRow = new Command(
        {u"duplicateRowButton"_s, {}, tr("Duplicate"), tr("Duplicate the selected row")}, box, [this] {
            const std::size_t row = *chosenRow();
            editRows(tr("Duplicate row"), [&](Sequence& sequence) {
                const Action copy = sequence.rows[row];
                insertRow(sequence, row + 1, copy);
            });
            m_rowTable->selectRow(static_cast<int>(row) + 1);
        });
    m_removeRow = new Command(
        {u"removeRowButton"_s, u"x"_s, tr("Remove row"), tr("Remove row: the selected one")}, box, [this] {
            editRows(tr("Remove row"),
                     [row = *chosenRow()](Sequence& sequence) { removeRow(sequence, row); });
        });
    m_rowUp = new Command(
        {u"rowUpButton"_s, {}, tr("Up"), tr("Up: move the selected row"), Qt::CTRL | Qt::SHIFT | Qt::Key_Up},
        box, [this] { moveRow(-1); });
    m_rowDown = new Command({u"rowDownButton"_s,
                             {},
                             tr("Down"),
                             tr("Down: move the selected row"),
                             Qt::CTRL | Qt::SHIFT | Qt::Key_Down},
                            box, [this] { moveRow(1); });
    m_undo = new Command({u"undoEditButton"_s, u"arrow-back-up"_s, Common::tr("Undo"),
                          tr("Undo the last change to points and sequences"), Qt::CTRL | Qt::ALT | Qt::Key_Z},
                         box, [this] { m_edits.undo(); });
    m_redo = new Command(
        {u"redoEditButton"_s, u"arrow-forward-up"_s, Common::tr("Redo"),
         tr("Redo the last undone change to points and sequences"), Qt::CTRL | Qt::ALT | Qt::Key_Y},
        box, [this] { m_edits.redo(); });
    return newRow(box, m_addRow, m_duplicateRow, m_removeRow, m_rowUp, m_rowDown, m_undo, m_redo);
}

QWidget* SequencesPage::buildRun() {
    auto* box = new QWidget(this);
    look::name(box, u"sequenceRunBox"_s, tr("Sequence"));
    m_sequence = form::newChoice({u"sequenceBox"_s, tr("Sequence"), {}}, box);
    m_sequence->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_sequence->setMinimumContentsLength(12);
    connect(m_sequence, &QComboBox::currentIndexChanged, this, &SequencesPage::showProgram);
    m_start = new Command({u"runSequenceButton"_s, u"player-play"_s, tr("Run"), tr("Run the sequence")}, box,
                          [this] { start(0, false); });
    m_startHere = new Command({u"runFromRowButton"_s, u"player-play"_s, tr("Run from row"),
                               tr("Run from row: start at the selected row")},
                              box, [this] { start(*chosenRow(), false); });
    m_pause = new Command({u"pauseSequenceButton"_s, u"player-pause"_s, Common::tr("Pause"),
                           tr("Pause the sequence after its row")},
                          box, [this] {
                              if (m_run->stage == SequenceStage::Paused)
                                  emit m_requests.resumeSequence();
                              else
                                  emit m_requests.pauseSequence();
                          });
    m_step = new Command({u"stepSequenceButton"_s, u"arrow-right"_s, tr("Single step"),
                          tr("Single step: run one row of the sequence")},
                         box, [this] {
                             if (running())
                                 emit m_requests.stepSequence();
                             else
                                 start(chosenRow().value_or(0), true);
                         });
    m_stop = new Command(
        {u"stopSequenceButton"_s, u"player-stop"_s, tr("Stop sequence"), tr("Stop sequence and its motors")},
        box, [this] { emit m_requests.stopSequence(); });
    m_foresee = new Command(
        {u"dryRunButton"_s, u"wand"_s, tr("Dry run"), tr("Dry run: simulate the sequence; nothing moves")},
        box, [this] {
            if (m_foreseeing) {
                m_foreseeing = false;
                m_foresight->clear();
                emit m_requests.foresightDropped();
            } else {
                m_foreseeing = true;
                m_foresight->setText(tr("Dry run…"));
                emit m_requests.foresee(sequence(), 0);
            }
            refreshRun();
        });
    // As wide as their longer text, so that no button moves under the pointer.
    const auto keepRoomFor = [](QPushButton* button, const QString& other) {
        const QString text = button->text();
        const int width = button->sizeHint().width();
        button->setText(other);
        button->setMinimumWidth(qMax(width, button->sizeHint().width()));
        button->setText(text);
    };
    keepRoomFor(m_pause->button(), tr("Continue"));
    keepRoomFor(m_foresee->button(), tr("End dry run"));
    auto* line = new QWidget(box);
    line->setLayout(new FlowLayout(look::gridUnit(box) / 2,
                                   {m_sequence, m_start->button(), m_pause->button(), m_stop->button(),
                                    m_startHere->button(), m_step->button(), m_foresee->button()}));
    m_state = new ElidedLabel(2, box);
    m_state->setObjectName(u"sequenceStateLabel"_s);
    box->setLayout(form::newColumn(box, {line, m_state}, form::kUsual));
    return box;
}

// ---- edits ----

void SequencesPage::edit(const QString& what, const std::function<void(Program&)>& change) {
    Program edited = m_machine.program;
    change(edited);
    // An editor may have been open when operator mode began.
    if (locked().isEmpty() && edited != m_machine.program && !contradiction(edited))
        m_edits.push(new Edit(*this, what, m_machine.program, std::move(edited)));
}

void SequencesPage::editRows(const QString& what, const std::function<void(Sequence&)>& change) {
    edit(what, [&](Program& program) {
        const auto found = std::ranges::find(program.sequences, sequence(), &Sequence::name);
        if (found != program.sequences.end())
            change(*found);
    });
}

void SequencesPage::put(const Program& program) {
    m_machine.program = program;
    showProgram();
    emit m_requests.programEdited(program);
}

void SequencesPage::teach() {
    const std::string name = m_pointName->text().simplified().toStdString();
    const std::vector<PointAxis> taught = nmc::teach(chosenAxes(), m_link);
    edit(tr("Teach point"), [&](Program& program) {
        const auto known = std::ranges::find(program.points, name, &Point::name);
        if (known != program.points.end())
            known->axes = taught;
        else
            program.points.push_back({name, taught});
    });
}

void SequencesPage::moveRow(int by) {
    const int to = static_cast<int>(*chosenRow()) + by;
    editRows(tr("Move row"), [&](Sequence& sequence) {
        std::ignore = nmc::moveRow(sequence, *chosenRow(), static_cast<std::size_t>(to));
    });
    m_rowTable->selectRow(to);
}

void SequencesPage::start(std::size_t row, bool singleStep) {
    emit m_requests.startSequence(sequence(), row, singleStep);
}

// ---- display ----

void SequencesPage::showSession(const LinkState& link, const Machine& machine) {
    m_link = link;
    m_link.modules = asOfSequence(link.modules);
    const bool another = machine.program != m_machine.program;
    m_machine = machine;
    showAxes();
    showProgram();
    if (another)
        m_edits.clear();  // another file: changes to the previous one cannot be undone in it
}

void SequencesPage::showRun(const SequenceReport& report) {
    m_run = report;
    refresh();
}

void SequencesPage::showForesight(const DryRun& dryRun) {
    if (!std::exchange(m_foreseeing, false))
        return;
    m_foresight->setText(texts::foreseen(dryRun, [this](ModuleIndex module) { return scaleOf(module); }));
    refreshRun();
}

void SequencesPage::showProgram() {
    QStringList names;
    for (const Sequence& sequence : m_machine.program.sequences)
        names << QString::fromStdString(sequence.name);
    QStringList shown;
    for (int i = 0; i < m_sequence->count(); ++i)
        shown << m_sequence->itemText(i);
    if (names != shown) {
        const QSignalBlocker blocker(m_sequence);
        const QString chosen = m_sequence->currentText();
        const int place = m_sequence->currentIndex();
        m_sequence->clear();
        m_sequence->addItems(names);
        // A renamed sequence is still at its place.
        const int found = static_cast<int>(names.indexOf(chosen));
        m_sequence->setCurrentIndex(found >= 0 ? found : qMin(place, static_cast<int>(names.size()) - 1));
        if (m_sequence->currentIndex() < 0 && !names.isEmpty())
            m_sequence->setCurrentIndex(0);
    }
    // What is being typed is a name for the sequence that was chosen.
    const QString named = m_sequence->currentText();
    if (std::exchange(m_named, named) != named || !m_sequenceName->hasFocus())
        m_sequenceName->setText(named);
    m_points->showPoints(m_machine.program.points, [this](ModuleIndex module) { return scaleOf(module); });
    const auto modules = static_cast<int>(std::max(m_link.modules.size(), m_machine.axes.size()));
    std::vector<ModuleType> types;
    for (int i = 0; i < modules; ++i) {
        const auto number = static_cast<std::size_t>(i);
        const auto& expected = m_machine.axis(ModuleIndex(static_cast<std::uint8_t>(i))).expected;
        types.push_back(number < m_link.modules.size() ? m_link.modules[number].info.identity.type
                        : expected                     ? expected->type
                                                       : ModuleType::Servo);
    }
    if (m_rows->showRows(m_machine.program, sequence(), modules, types)) {
        // A dry run was one of the rows before.
        m_foreseeing = false;
        m_foresight->clear();
    }
    refresh();
}

/// Rows are only hidden: the user's ticks are kept while the chain is away.
void SequencesPage::showAxes() {
    const QSignalBlocker blocker(m_axes);
    const auto modules = static_cast<int>(m_link.modules.size());
    while (m_axes->count() < modules) {
        auto* item = new QListWidgetItem(m_axes);
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsUserCheckable | Qt::ItemIsSelectable);
        item->setCheckState(Qt::Checked);
    }
    for (int i = 0; i < m_axes->count(); ++i) {
        QListWidgetItem* item = m_axes->item(i);
        const ModuleState* module = i < modules ? &m_link.modules[static_cast<std::size_t>(i)] : nullptr;
        // Other modules never have a position. The list places all rows again even if nothing changes.
        const bool hidden = module == nullptr || !(module->isServo() || module->isStepper());
        if (item->isHidden() != hidden)
            item->setHidden(hidden);
        if (module != nullptr)
            item->setText(texts::moduleName(module->info.index));
    }
}

void SequencesPage::refresh() {
    const bool marked = m_run && m_run->stage != SequenceStage::Done && !m_run->places.empty() &&
                        m_run->places.front().sequence == sequence();
    m_rows->markRow(marked ? std::optional(m_run->places.front().row) : std::nullopt);
    refreshPoints();
    refreshRows();
    refreshRun();
}

QString SequencesPage::locked() const {
    const auto refusal = whyNotEdited(m_link.rights);
    return refusal ? texts::refusal(*refusal) : QString();
}

QString SequencesPage::whyNotTaught() const {
    if (const QString reason = locked(); !reason.isEmpty())
        return reason;
    if (const auto refusal = whyNoChain(m_link))
        return texts::refusal(*refusal);
    if (m_pointName->text().simplified().isEmpty())
        return tr("Enter a name for the point first.");
    if (chosenAxes().empty())
        return tr("Select at least one axis.");
    for (const ModuleIndex axis : chosenAxes())
        if (nmc::teach({axis}, m_link).empty()) {
            const ModuleState* module = moduleAt(axis, m_link.modules);
            const bool otherType = module != nullptr && module->otherType();
            return Common::tr("%1: %2").arg(
                texts::moduleName(axis),
                texts::refusal(otherType ? Refusal::OtherType : Refusal::PositionUnknown));
        }
    return {};
}

void SequencesPage::refreshPoints() {
    m_teach->setPossible(
        whyNotTaught(),
        tr("Stores the present positions of the selected axes under this name, replacing any point of that name. Nothing moves."));
    const Point* point = chosenPoint();
    const QString none = tr("Select a point in the table.");
    QString reason = none;
    QString used = none;
    if (point != nullptr) {
        reason = whyNotStarted(kMoveToPoint, 0, withMoveTo(m_machine, point->name));
        const auto user = userOfPoint(m_machine.program, point->name);
        used = user ? tr("Row %1 of \"%2\" uses this point. Change that row first.")
                          .arg(user->row + 1)
                          .arg(QString::fromStdString(user->sequence))
                    : QString();
    }
    m_goTo->setPossible(reason, tr("Moves all axes of this point there together, each at its own velocity."));
    m_removePoint->setPossible(locked().isEmpty() ? used : locked(),
                               tr("Removes this point; nothing moves."));
}

void SequencesPage::refreshRows() {
    const std::optional<std::size_t> row = chosenRow();
    const bool any = m_sequence->currentIndex() >= 0;
    const QString reason = locked();
    const bool free = reason.isEmpty();
    const QString noSequence = !free ? reason : any ? QString() : tr("No sequence yet. Add one first.");
    const QString noRow = !free ? reason : row ? QString() : tr("Select a row in the table.");
    for (QTableView* table : {m_pointTable, m_rowTable})
        table->setEditTriggers(free ? kEditTriggers : QAbstractItemView::NoEditTriggers);
    m_rowTable->setToolTip(free ? tr("Double-click a cell or press F2 to edit it.") : reason);
    look::setPossible(m_sequenceName, noSequence, tr("Type a new name for this sequence, then press Enter."));
    m_newSequence->setPossible(reason, tr("Adds an empty sequence."));
    const auto caller = userOfSequence(m_machine.program, sequence());
    m_removeSequence->setPossible(!any || !free ? noSequence
                                  : caller
                                      ? tr("Row %1 of \"%2\" calls this sequence. Change that row first.")
                                            .arg(caller->row + 1)
                                            .arg(QString::fromStdString(caller->sequence))
                                      : QString(),
                                  tr("Removes this sequence with its rows."));
    m_addRow->setPossible(noSequence, tr("Adds a row after the selected one, or at the end."));
    m_duplicateRow->setPossible(noRow, tr("Adds a copy of the row after it."));
    m_removeRow->setPossible(noRow, tr("Removes this row."));
    const auto whyNotMoved = [&](int by) {
        if (!row || !free)
            return noRow;
        const int to = static_cast<int>(*row) + by;
        Sequence tried = *m_machine.program.sequence(sequence());
        if (to < 0 || !nmc::moveRow(tried, *row, static_cast<std::size_t>(to)))
            return tr("The row cannot move farther: a repeat must stay below the row it goes back to.");
        return QString();
    };
    m_rowUp->setPossible(whyNotMoved(-1), tr("Moves this row up."));
    m_rowDown->setPossible(whyNotMoved(1), tr("Moves this row down."));
    m_undo->setPossible(!free               ? reason
                        : m_edits.canUndo() ? QString()
                                            : Common::tr("Nothing to undo."),
                        tr("Undo: %1").arg(m_edits.undoText()));
    m_redo->setPossible(!free               ? reason
                        : m_edits.canRedo() ? QString()
                                            : Common::tr("Nothing to redo."),
                        tr("Redo: %1").arg(m_edits.redoText()));
}

QString SequencesPage::whyNotStarted(const std::string& sequence, std::size_t row,
                                     const Machine& machine) const {
    if (running())
        return Common::tr("A sequence is already running.");
    if (const auto refusal = whyNoChain(m_link))
        return texts::refusal(*refusal);
    if (sequence.empty())
        return tr("No sequence yet. Add one first.");
    const auto problems = nmc::whyNotRun(sequence, row, machine, m_link.modules);
    return problems.empty() ? QString() : texts::sequenceProblem(problems.front());
}

void SequencesPage::refreshRun() {
    const QString name = QString::fromStdString(sequence());
    m_start->setPossible(whyNotStarted(sequence(), 0, m_machine),
                         tr("Runs \"%1\" from its first row.").arg(name));
    m_startHere->setPossible(
        chosenRow() ? whyNotStarted(sequence(), *chosenRow(), m_machine) : tr("Select a row in the table."),
        tr("Runs \"%1\" from the selected row on. The axes must be where the rows above leave them.")
            .arg(name));
    const QString nothing = running() ? QString() : tr("No sequence is running.");
    const bool paused = running() && m_run->stage == SequenceStage::Paused;
    m_pause->setText(paused ? tr("Continue") : Common::tr("Pause"));
    m_pause->setPossible(nothing, paused ? tr("Continues from where it paused.")
                                         : tr("Finishes the current row, then waits."));
    m_step->setPossible(running() && !paused ? tr("The sequence is running. Pause it first.")
                        : paused             ? QString()
                                             : whyNotStarted(sequence(), chosenRow().value_or(0), m_machine),
                        tr("Runs one row, then waits. Starts with the selected row."));
    m_stop->setPossible(nothing, tr("Ends the sequence and stops its motors smoothly."));
    m_foresee->setText(m_foreseeing ? tr("End dry run") : tr("Dry run"));
    const auto noChain = whyNoChain(m_link);
    m_foresee->setPossible(
        noChain          ? texts::refusal(*noChain)
        : name.isEmpty() ? tr("No sequence yet. Add one first.")
                         : QString(),
        tr("Simulates the sequence: shows how long it takes, where each axis goes and what would be refused. Nothing moves."));
    look::setText(m_state, m_run ? texts::sequenceState(*m_run) : QString());
}

// ---- selection ----

std::vector<ModuleIndex> SequencesPage::chosenAxes() const {
    std::vector<ModuleIndex> axes;
    for (int i = 0; i < m_axes->count(); ++i)
        if (const auto* item = m_axes->item(i); !item->isHidden() && item->checkState() == Qt::Checked)
            axes.emplace_back(static_cast<std::uint8_t>(i));
    return axes;
}

std::string SequencesPage::sequence() const {
    return m_sequence->currentText().toStdString();
}

const Point* SequencesPage::chosenPoint() const {
    const QModelIndexList rows = m_pointTable->selectionModel()->selectedRows();
    const bool any =
        !rows.isEmpty() && rows.front().row() < static_cast<int>(m_machine.program.points.size());
    return any ? &m_machine.program.points[static_cast<std::size_t>(rows.front().row())] : nullptr;
}

std::optional<std::size_t> SequencesPage::chosenRow() const {
    const QModelIndexList rows = m_rowTable->selectionModel()->selectedRows();
    const Sequence* shown = m_machine.program.sequence(sequence());
    // The table may call this while it still has its previous rows.
    if (rows.isEmpty() || shown == nullptr ||
        rows.front().row() >= static_cast<int>(std::min(shown->rows.size(), m_rows->rows().size())))
        return std::nullopt;
    return static_cast<std::size_t>(rows.front().row());
}

AxisScale SequencesPage::scaleOf(ModuleIndex module) const {
    const AxisSettings& axis = m_machine.axis(module);
    return nmc::scaleOf(moduleAt(module, m_link.modules), axis, axis.expected);
}

}  // namespace nmc
