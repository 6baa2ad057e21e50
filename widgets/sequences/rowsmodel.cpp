// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/sequences/rowsmodel.h"

#include <QFont>
#include <QPointF>

#include "base/overloaded.h"
#include "model/sequence/sequencecheck.h"
#include "protocol/iocommands.h"
#include "widgets/common/sequencetexts.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/words.h"
#include "widgets/sequences/tablerows.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {

constexpr int kMotorPins = 5;
constexpr int kMotorOutputs = 5;
constexpr int kIoPins = io::kPins;
constexpr double kDay = 86'400.0;
constexpr int kSecondDecimals = 3;

int indexOfName(const std::vector<std::string>& names, const std::string& name) {
    const auto found = std::ranges::find(names, name);
    return found != names.end() ? static_cast<int>(found - names.begin()) : -1;
}

QStringList toList(const std::vector<std::string>& names) {
    QStringList list;
    for (const std::string& name : names)
        list << QString::fromStdString(name);
    return list;
}

std::vector<std::string> pointNames(const Program& program) {
    std::vector<std::string> names;
    for (const Point& point : program.points)
        names.push_back(point.name);
    return names;
}

/// The sequences that can be called without leading back to `sequence`.
std::vector<std::string> callable(const Program& program, const std::string& sequence) {
    std::vector<std::string> names;
    for (const Sequence& other : program.sequences) {
        Program tried = program;
        for (Sequence& caller : tried.sequences)
            if (caller.name == sequence)
                caller.rows.emplace_back(action::Call{other.name});
        const auto problem = contradiction(tried);
        if (!problem || problem->kind != SequenceProblem::Kind::CallsItself)
            names.push_back(other.name);
    }
    return names;
}

ModuleIndex chosenModule(int choice) {
    return ModuleIndex(static_cast<std::uint8_t>(choice));
}

}  // namespace

bool RowsModel::showRows(const Program& program, const std::string& sequence, int modules,
                         const std::vector<ModuleType>& types) {
    QStringList names;
    for (int i = 0; i < modules; ++i)
        names << texts::moduleName(chosenModule(i));
    const bool otherwise =
        program != m_program || sequence != m_sequence || names != m_names || types != m_types;
    if (!otherwise)
        return false;
    const Sequence* shown = program.sequence(sequence);
    const std::vector<Action> rows = shown != nullptr ? shown->rows : std::vector<Action>{};
    changeRowCount(*this, m_rows, rows);
    if (program != m_program || sequence != m_sequence)
        m_callable = callable(program, sequence);
    m_program = program;
    m_sequence = sequence;
    m_names = names;
    m_types = types;
    m_rows = rows;
    if (!m_rows.empty())
        emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
    return true;
}

void RowsModel::markRow(std::optional<std::size_t> row) {
    if (m_marked == row)
        return;
    for (const auto& changed : {std::exchange(m_marked, row), row})
        if (changed && *changed < m_rows.size())
            emit dataChanged(index(static_cast<int>(*changed), 0),
                             index(static_cast<int>(*changed), ColumnCount - 1));
    if (!m_rows.empty())
        emit headerDataChanged(Qt::Vertical, 0, rowCount() - 1);
}

Action RowsModel::newRow() const {
    return actionOf(m_program.points.empty() ? 1 : 0, 0);
}

Action RowsModel::actionOf(std::size_t kind, std::size_t row) const {
    action::WaitForInput wait{};
    takeModule(wait, wait.module);
    const Action all[] = {
        action::MoveTo{m_program.points.empty() ? std::string() : m_program.points.front().name},
        action::Wait{},
        action::WaitForArrival{},
        wait,
        action::SetOutput{},
        action::Home{},
        action::Repeat{row > 0 ? row - 1 : 0, 2},
        action::Call{m_callable.empty() ? std::string() : m_callable.front()},
        action::WaitForAnalog{.module = firstIo()}};
    return all[kind];
}

std::vector<std::size_t> RowsModel::possibleActions(std::size_t row) const {
    std::vector<std::size_t> kinds;
    for (std::size_t kind = 0; kind < std::variant_size_v<Action>; ++kind) {
        const Action action = actionOf(kind, row);
        const bool lacks = (std::holds_alternative<action::MoveTo>(action) && m_program.points.empty()) ||
                           (std::holds_alternative<action::Repeat>(action) && row == 0) ||
                           (std::holds_alternative<action::Call>(action) && m_callable.empty()) ||
                           (std::holds_alternative<action::WaitForAnalog>(action) && !isIo(firstIo()));
        if (!lacks || kind == m_rows[row].index())
            kinds.push_back(kind);
    }
    return kinds;
}

bool RowsModel::isIo(ModuleIndex module) const {
    return module.value() < m_types.size() && m_types[module.value()] == ModuleType::Io;
}

/// The first PIC-I/O, or the first module if there is none.
ModuleIndex RowsModel::firstIo() const {
    const auto found = std::ranges::find(m_types, ModuleType::Io);
    return chosenModule(found != m_types.end() ? static_cast<int>(found - m_types.begin()) : 0);
}

void RowsModel::takeModule(action::WaitForInput& wait, ModuleIndex module) const {
    wait.module = module;
    if (isIo(module) != ioPin(wait.pin).has_value())
        wait.pin = isIo(module) ? InputPin::Io1 : InputPin::Limit1;
}

void RowsModel::takeModule(action::SetOutput& set, ModuleIndex module) const {
    set.module = module;
    if (!isIo(module) && set.output > kMotorOutputs)
        set.output = 1;
}

RowsModel::Cell RowsModel::cell(std::size_t row, int column) const {
    const Action& action = m_rows[row];
    if (column == How)
        return how(action);
    if (column == Number)
        return number(action);
    if (column == Within)
        return within(action);
    if (column == What)
        return what(row);
    Cell cell;
    for (const std::size_t kind : possibleActions(row)) {
        if (kind == action.index())
            cell.chosen = static_cast<int>(cell.choices.size());
        cell.choices << texts::actionWord(kind);
    }
    return cell;
}

RowsModel::Cell RowsModel::what(std::size_t row) const {
    const Action& action = m_rows[row];
    Cell cell;
    if (const auto module = moduleOf(action)) {
        cell = {m_names, module->value()};
        if (module->value() >= m_names.size())
            cell.text = texts::moduleName(*module);
    } else if (const auto* move = std::get_if<action::MoveTo>(&action)) {
        const auto names = pointNames(m_program);
        cell = {toList(names), indexOfName(names, move->point)};
    } else if (const auto* call = std::get_if<action::Call>(&action)) {
        cell = {toList(m_callable), indexOfName(m_callable, call->sequence)};
    } else if (const auto* repeat = std::get_if<action::Repeat>(&action)) {
        cell.chosen = static_cast<int>(repeat->from);
        for (std::size_t i = 0; i < row; ++i)
            cell.choices << tr("from row %1 on").arg(i + 1);
    }
    return cell;
}

/// How a move is made, or which pins, outputs or A/D inputs a module has, each with both levels. Those of a
/// PIC-I/O are named as in its data sheet.
RowsModel::Cell RowsModel::how(const Action& action) const {
    Cell cell;
    if (const auto* move = std::get_if<action::MoveTo>(&action)) {
        cell.choices = {tr("together"), tr("together, next row at once"), tr("one after the other"),
                        tr("one after the other, next row at once")};
        cell.chosen = (move->together ? 0 : 2) + (move->waits ? 0 : 1);
    } else if (const auto* wait = std::get_if<action::WaitForInput>(&action)) {
        const bool io = ioPin(wait->pin).has_value();
        for (int pin = 0; pin < (io ? kIoPins : kMotorPins); ++pin)
            for (const QString& level :
                 {io ? tr("%1 high") : tr("%1 active"), io ? tr("%1 low") : tr("%1 not active")})
                cell.choices << level.arg(texts::pinWord(static_cast<InputPin>(io ? kMotorPins + pin : pin)));
        cell.chosen = static_cast<int>(ioPin(wait->pin).value_or(static_cast<unsigned>(wait->pin))) * 2 +
                      (wait->active ? 0 : 1);
    } else if (const auto* set = std::get_if<action::SetOutput>(&action)) {
        const bool io = isIo(set->module) || set->output > kMotorOutputs;
        for (int output = 1; output <= (io ? kIoPins : kMotorOutputs); ++output)
            for (const QString& level :
                 {io ? tr("IO%1 high") : tr("output %1 on"), io ? tr("IO%1 low") : tr("output %1 off")})
                cell.choices << level.arg(output);
        cell.chosen = static_cast<int>(set->output - 1) * 2 + (set->on ? 0 : 1);
    } else if (const auto* analog = std::get_if<action::WaitForAnalog>(&action)) {
        for (int input = 1; input <= io::kAnalogInputs; ++input)
            for (const QString& side : {tr("A/D %1 above"), tr("A/D %1 below")})
                cell.choices << side.arg(input);
        cell.chosen = static_cast<int>(analog->input - 1) * 2 + (analog->above ? 0 : 1);
    }
    return cell;
}

RowsModel::Cell RowsModel::number(const Action& action) {
    Cell cell;
    if (const auto* move = std::get_if<action::MoveTo>(&action)) {
        cell = {.number = move->percent, .min = 1, .max = 100};
        cell.text = tr("%1 % of its velocity").arg(move->percent);
    } else if (const auto* wait = std::get_if<action::Wait>(&action)) {
        cell = {.number = wait->seconds, .min = 0, .max = kDay, .decimals = kSecondDecimals};
        cell.text = tr("%1 s").arg(texts::readout(wait->seconds));
    } else if (const auto* input = std::get_if<action::WaitForInput>(&action)) {
        cell = {.number = input->timeout, .min = 0, .max = kDay, .decimals = kSecondDecimals};
        cell.text = tr("within %1 s").arg(texts::readout(input->timeout));
    } else if (const auto* analog = std::get_if<action::WaitForAnalog>(&action)) {
        cell = {.number = analog->level, .min = 0, .max = 255};
        cell.text = Common::tr("%1 of 255").arg(analog->level);
    } else if (const auto* repeat = std::get_if<action::Repeat>(&action)) {
        cell = {.number = repeat->times, .min = 0, .max = 1'000'000};
        cell.text = repeat->times == 0 ? tr("forever")
                                       : tr("%n times in all", nullptr, static_cast<int>(repeat->times));
    }
    return cell;
}

/// The time limit of a row whose number is something else.
RowsModel::Cell RowsModel::within(const Action& action) {
    Cell cell;
    if (const auto* analog = std::get_if<action::WaitForAnalog>(&action)) {
        cell = {.number = analog->timeout, .min = 0, .max = kDay, .decimals = kSecondDecimals};
        cell.text = tr("within %1 s").arg(texts::readout(analog->timeout));
    }
    return cell;
}

void RowsModel::choose(Action& action, std::size_t row, int column, int choice) const {
    const auto index = static_cast<std::size_t>(choice);
    if (column == Do) {
        action = actionOf(possibleActions(row)[index], row);
        return;
    }
    const bool second = choice % 2 == 1;
    std::visit(Overloaded{
                   [&](action::MoveTo& move) {
                       if (column == What) {
                           move.point = m_program.points[index].name;
                           return;
                       }
                       move.together = choice < 2;
                       move.waits = !second;
                   },
                   [&](action::WaitForInput& wait) {
                       if (column == What)
                           return takeModule(wait, chosenModule(choice));
                       wait.pin = ioPin(wait.pin) ? inputPin(static_cast<unsigned>(choice / 2))
                                                  : static_cast<InputPin>(choice / 2);
                       wait.active = !second;
                   },
                   [&](action::SetOutput& set) {
                       if (column == What)
                           return takeModule(set, chosenModule(choice));
                       set.output = static_cast<unsigned>(choice / 2 + 1);
                       set.on = !second;
                   },
                   [&](action::WaitForAnalog& wait) {
                       if (column == What) {
                           wait.module = chosenModule(choice);
                           return;
                       }
                       wait.input = static_cast<unsigned>(choice / 2 + 1);
                       wait.above = !second;
                   },
                   [&](action::Home& home) { home.module = chosenModule(choice); },
                   [&](action::Repeat& repeat) { repeat.from = index; },
                   [&](action::Call& call) { call.sequence = m_callable[index]; },
                   [](AnyOf<action::Wait, action::WaitForArrival> auto&) {},
               },
               action);
}

int RowsModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int RowsModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant RowsModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount())
        return {};
    const auto row = static_cast<std::size_t>(index.row());
    if (role == Qt::FontRole) {
        QFont font;
        font.setBold(m_marked == row);
        return m_marked == row ? QVariant(font) : QVariant();
    }
    const Cell cell = this->cell(row, index.column());
    if (role == ChoicesRole)
        return cell.choices;
    if (role == RangeRole)
        return QPointF(cell.min, cell.max);
    if (role == DecimalsRole)
        return cell.decimals;
    if (role == Qt::EditRole)
        return cell.number ? QVariant(*cell.number) : QVariant(cell.chosen);
    if (role != Qt::DisplayRole && role != Qt::ToolTipRole)
        return {};
    const bool known = cell.chosen >= 0 && cell.chosen < cell.choices.size();
    return known ? cell.choices[cell.chosen] : cell.text;
}

QVariant RowsModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (role != Qt::DisplayRole)
        return {};
    if (orientation == Qt::Vertical) {
        const bool marked = m_marked && section == static_cast<int>(*m_marked);
        return marked ? u"▸ %1"_s.arg(section + 1) : QString::number(section + 1);
    }
    switch (section) {
        case Do:
            return tr("Action");
        case What:
            return tr("Target");
        case How:
            return Common::tr("How");
        case Number:
            return tr("Value");
        default:
            return tr("Within");
    }
}

Qt::ItemFlags RowsModel::flags(const QModelIndex& index) const {
    const Qt::ItemFlags flags = QAbstractTableModel::flags(index);
    if (!index.isValid() || index.row() >= rowCount())
        return flags;
    const Cell cell = this->cell(static_cast<std::size_t>(index.row()), index.column());
    return cell.number || !cell.choices.isEmpty() ? flags | Qt::ItemIsEditable : flags;
}

bool RowsModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (!index.isValid() || index.row() >= rowCount() || role != Qt::EditRole)
        return false;
    const auto row = static_cast<std::size_t>(index.row());
    const Cell cell = this->cell(row, index.column());
    Action action = m_rows[row];
    bool fits = false;
    const double number = value.toDouble(&fits);
    if (!fits)
        return false;
    if (cell.number) {
        if (number < cell.min || number > cell.max)
            return false;
        std::visit(
            Overloaded{
                [&](action::MoveTo& move) { move.percent = static_cast<unsigned>(number); },
                [&](action::Wait& wait) { wait.seconds = number; },
                [&](action::WaitForInput& wait) { wait.timeout = number; },
                [&](action::Repeat& repeat) { repeat.times = static_cast<unsigned>(number); },
                [&](action::WaitForAnalog& wait) {
                    if (index.column() == Within)
                        wait.timeout = number;
                    else
                        wait.level = static_cast<unsigned>(number);
                },
                [](AnyOf<action::WaitForArrival, action::SetOutput, action::Home, action::Call> auto&) {},
            },
            action);
    } else {
        if (number < 0 || number >= static_cast<double>(cell.choices.size()))
            return false;
        // What is already chosen stays as it is: a choice may reset what else the row says.
        if (static_cast<int>(number) == cell.chosen)
            return false;
        choose(action, row, index.column(), static_cast<int>(number));
    }
    if (action == m_rows[row])
        return false;
    emit rowEdited(index.row(), action);
    return true;
}

}  // namespace nmc
