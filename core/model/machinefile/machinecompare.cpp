// SPDX-License-Identifier: MIT
#include "model/machinefile/machinecompare.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "model/machinefile/fieldlist.h"

namespace nmc {

namespace {

using layout::FieldList;
using layout::ListedField;
using Fields = std::vector<ListedField>;

/// The parts of an axis, in the order of the table.
constexpr MachinePart kAxisParts[] = {
    MachinePart::AxisName,        MachinePart::Unit,   MachinePart::Motion,    MachinePart::Travel,
    MachinePart::Backlash,        MachinePart::Homing, MachinePart::LimitStop, MachinePart::Analog,
    MachinePart::PinNames,        MachinePart::Gains,  MachinePart::Io,        MachinePart::Parameters,
    MachinePart::AccelerationTime};
constexpr MachinePart kMachineParts[] = {MachinePart::MachineName, MachinePart::Rate,
                                         MachinePart::Groups,      MachinePart::Program,
                                         MachinePart::HomeOrder,   MachinePart::OperatorRights};

/// A CMC has it among its limit pins.
constexpr std::string_view kScFastPath = "sc_fast_path";

bool isSent(MachinePart part) {
    return part == MachinePart::Gains || part == MachinePart::Io || part == MachinePart::Parameters;
}

const ModuleState* connected(const std::vector<ModuleState>& modules, std::optional<ModuleIndex> index) {
    return index && index->value() < modules.size() ? &modules[index->value()] : nullptr;
}

/// Which axes of the file meet a module that they are not for.
bool forOther(const AxisSettings& axis, const ModuleState* module) {
    return module != nullptr && axis.expected && *axis.expected != module->info.identity;
}

/// The file's gains as this module takes them: an old one has no deadband, and only an SC a step multiplier,
/// which stays where the file does not say it (gainsplan.cpp).
std::optional<servo::SetGain> gainsFor(const AxisSettings& axis, const ModuleState* module) {
    std::optional<servo::SetGain> gains = axis.gains;
    if (gains && module != nullptr && module->info.identity.version < servo::kDeadbandVersion)
        gains->db.reset();
    if (gains && module != nullptr && !isSc(module->info.identity))
        gains->sm.reset();
    else if (gains && module != nullptr && !gains->sm && module->gains)
        gains->sm = module->gains->sm;
    return gains;
}

Fields groupFields(const std::vector<GroupSettings>& groups) {
    FieldList list;
    for (const GroupSettings& group : groups) {
        std::string members;
        for (const ModuleIndex member : group.members)
            members += (members.empty() ? "" : ", ") + std::to_string(member.value() + 1);
        const std::string number = std::to_string(group.address);
        list.add("group" + number, Quantity::Plain,
                 group.name.empty() ? members : group.name + ": " + members);
        if (group.leader)
            list.whole("leader" + number, group.leader->value() + 1, {});
    }
    return list.fields();
}

std::string valueText(const FieldValue& value) {
    if (const auto* flag = std::get_if<bool>(&value))
        return *flag ? "yes" : "no";
    if (const auto* text = std::get_if<std::string>(&value))
        return *text;
    const double number = std::get<double>(value);
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
    return {digits.data(), end};
}

/// One text for all of them: what differs in anything differs here.
template <typename Part>
std::string inOneText(const std::vector<Part>& parts) {
    std::string text;
    for (const Part& part : parts) {
        text += text.empty() ? "" : "; ";
        bool first = true;
        for (const ListedField& field : layout::listed(part)) {
            const bool named = field.key != "do";
            text += (first ? "" : ", ") + (named ? field.key + ' ' : std::string()) + valueText(field.value);
            first = false;
        }
    }
    return text.empty() ? "-" : text;
}

Fields programFields(const Program& program) {
    FieldList list;
    for (const Point& point : program.points)
        list.add("point " + point.name, Quantity::Plain, inOneText(point.axes));
    for (const Sequence& sequence : program.sequences)
        list.add("sequence " + sequence.name, Quantity::Plain, inOneText(sequence.rows));
    return list.fields();
}

Fields orderFields(const std::vector<ModuleIndex>& order) {
    FieldList list;
    std::string text;
    for (const ModuleIndex module : order)
        text += (text.empty() ? "" : ", ") + std::to_string(module.value() + 1);
    list.text("home_order", text);
    return list.fields();
}

Fields machineFields(const Machine& machine, MachinePart part) {
    FieldList list;
    if (part == MachinePart::MachineName)
        list.text("name", machine.name);
    else if (part == MachinePart::Rate && machine.baud != 0)
        list.whole("rate_bd", machine.baud, {});
    else if (part == MachinePart::Groups)
        return groupFields(machine.groups);
    else if (part == MachinePart::Program)
        return programFields(machine.program);
    else if (part == MachinePart::HomeOrder)
        return orderFields(machine.homeOrder);
    else if (part == MachinePart::OperatorRights)
        return layout::listed(machine.operatorRights);
    return list.fields();
}

/// Those that were set, each in one text.
template <typename Part>
void listSet(FieldList& list, const std::string& key, const std::vector<Part>& parts) {
    for (std::size_t i = 0; i < parts.size(); ++i)
        if (!(parts[i] == Part{}))
            list.add(key + std::to_string(i + 1), Quantity::Plain, inOneText(std::vector{parts[i]}));
}

void listPins(FieldList& list, const PinSettings& settings) {
    listSet(list, "IO", settings.pins);
    listSet(list, "PWM", settings.pwm);
    for (std::size_t i = 0; i < settings.analog.size(); ++i) {
        list.text("AD" + std::to_string(i + 1), settings.analog[i].name);
        if (!(settings.analog[i].scale == AnalogScale{}))
            list.add("AD" + std::to_string(i + 1) + " scale", Quantity::Plain,
                     inOneText(std::vector{settings.analog[i].scale}));
    }
}

Fields axisFields(const AxisSettings& axis, MachinePart part) {
    FieldList list;
    switch (part) {
        case MachinePart::AxisName:
            list.text("name", axis.name);
            break;
        case MachinePart::Unit:
            return layout::listed(axis.unit);
        case MachinePart::Motion:
            return layout::listed(axis.motion);
        case MachinePart::Travel:
            return layout::listed(axis.travel);
        case MachinePart::Backlash:
            return layout::listedUnless(axis.backlash, BacklashSettings{});
        case MachinePart::Homing:
            return layout::listed(axis.homing);
        case MachinePart::LimitStop:
            return layout::listedUnless(axis.limitStop, LimitStopSettings{});
        case MachinePart::Analog:
            return layout::listed(axis.analog);
        case MachinePart::PinNames:
            list.names("output", axis.outputNames);
            list.names("input", axis.inputNames);
            if (axis.pins)
                listPins(list, *axis.pins);
            break;
        case MachinePart::AccelerationTime:
            if (axis.accelerationTime > 0)
                list.real("acceleration_time", axis.accelerationTime, {});
            break;
        case MachinePart::Gains:
            return layout::listed(axis.gains);
        case MachinePart::Io:
            if (axis.io)
                layout::fields(list, *axis.io);
            list.flag(kScFastPath, axis.fastPath);
            break;
        case MachinePart::Parameters:
            return layout::listed(axis.parameters);
        case MachinePart::MachineName:
        case MachinePart::Rate:
        case MachinePart::Groups:
        case MachinePart::Program:
        case MachinePart::HomeOrder:
        case MachinePart::OperatorRights:
        case MachinePart::Hardware:
            break;
    }
    return list.fields();
}

const ListedField* findField(const Fields& fields, const std::string& key) {
    const auto found =
        std::find_if(fields.begin(), fields.end(), [&key](const ListedField& f) { return f.key == key; });
    return found != fields.end() ? &*found : nullptr;
}

std::vector<FieldDifference> differing(const Fields& file, const Fields& now) {
    std::vector<FieldDifference> found;
    for (const ListedField& field : file) {
        const ListedField* other = findField(now, field.key);
        if (other == nullptr)
            found.push_back({field.key, field.quantity, field.value, std::nullopt});
        else if (other->value != field.value)
            found.push_back({field.key, field.quantity, field.value, other->value});
    }
    for (const ListedField& field : now)
        if (findField(file, field.key) == nullptr)
            found.push_back({field.key, field.quantity, std::nullopt, field.value});
    return found;
}

// ---- what can be sent: these three go together ----

/// What the module was told in this connection; nothing: unknown.
Fields sentFields(const ModuleState& module, MachinePart part) {
    if (part == MachinePart::Gains)
        return layout::listed(module.gains);
    if (part == MachinePart::Io && isSc(module.info.identity)) {
        FieldList list;
        if (module.scIo)
            list.flag(kScFastPath, module.scIo->fastPath);
        return list.fields();
    }
    if (part == MachinePart::Io)
        return layout::listed(module.io);
    return layout::listed(module.stepper.parameters());
}

/// I/O Control of an SC applies every bit: nothing while the others are not known.
std::optional<Intent> fastPathOf(const AxisSettings& axis, const ModuleState& module) {
    if (!axis.fastPath || !module.scIo)
        return std::nullopt;
    servo::ScIoControl io = *module.scIo;
    io.fastPath = *axis.fastPath;
    return intent::ControlSc{io};
}

std::optional<Intent> intentOf(const AxisSettings& axis, MachinePart part, const ModuleState& module) {
    if (part == MachinePart::Io && isSc(module.info.identity))
        return fastPathOf(axis, module);
    if (part == MachinePart::Gains && axis.gains)
        return intent::ApplyGains{*axis.gains};
    if (part == MachinePart::Io && axis.io)
        return intent::ControlIo{*axis.io};
    if (part == MachinePart::Parameters && axis.parameters)
        return stepperintent::SetParameters{*axis.parameters};
    return std::nullopt;
}

std::optional<Refusal> whyNotSent(MachinePart part, const ModuleState& module) {
    if (part == MachinePart::Parameters)
        return whyNot(IntentKind::SetParameters, module);
    if (part == MachinePart::Io && isSc(module.info.identity))
        return whyNot(IntentKind::ControlSc, module);
    return whyNot(part == MachinePart::Io ? IntentKind::ControlIo : IntentKind::ApplyGains, module);
}

/// Compares axis by axis what the file says with what is.
class Comparison {
public:
    Comparison(const Machine& file, const Machine& now, const std::vector<ModuleState>& modules)
        : m_file(file), m_now(now), m_modules(modules) {}

    std::vector<Difference> rows() && {
        for (const MachinePart part : kMachineParts)
            add({{{}, part}, differing(machineFields(m_file, part), machineFields(m_now, part))});
        const std::size_t axes = std::max({m_file.axes.size(), m_now.axes.size(), m_modules.size()});
        for (std::size_t i = 0; i < axes; ++i)
            compareAxis(ModuleIndex(static_cast<std::uint8_t>(i)));
        return std::move(m_rows);
    }

private:
    void add(Difference row) {
        if (!row.fields.empty())
            m_rows.push_back(std::move(row));
    }
    void compareAxis(ModuleIndex index) {
        const ModuleState* module = connected(m_modules, index);
        const bool inFile = index.value() < m_file.axes.size();
        const AxisSettings file = m_file.axis(index);
        if (!m_modules.empty() && !compareHardware(index, module, inFile, file))
            return;
        for (const MachinePart part : kAxisParts)
            comparePart({index, part}, file, module);
    }
    /// False: nothing more is to be said of this axis.
    bool compareHardware(ModuleIndex index, const ModuleState* module, bool inFile,
                         const AxisSettings& file) {
        Difference row{{index, MachinePart::Hardware}, {}};
        row.wanted = false;
        if (module != nullptr && !inFile)
            row.applying = Applying::NotInFile;
        else if (module == nullptr && inFile)
            row.applying = Applying::NotThere;
        else if (forOther(file, module))
            row.applying = Applying::OtherHardware;
        else
            return true;
        row.fields = {{"hardware", Quantity::Plain, identityText(file.expected),
                       module != nullptr ? identityText(module->info.identity) : std::nullopt}};
        m_rows.push_back(std::move(row));
        return m_rows.back().applying == Applying::NotThere;
    }
    /// In the words of the file, for the table.
    static std::optional<FieldValue> identityText(const std::optional<ModuleIdentity>& identity) {
        if (!identity)
            return std::nullopt;
        for (const auto& word : layout::kTypeWords)
            if (word.value == identity->type)
                return std::string(word.text) + " v" + std::to_string(identity->version);
        return "type " + std::to_string(static_cast<int>(identity->type)) + " v" +
               std::to_string(identity->version);
    }
    void comparePart(PartId id, const AxisSettings& axis, const ModuleState* module) {
        AxisSettings file = axis;
        file.gains = gainsFor(file, module);
        AxisSettings now = m_now.axis(*id.module);
        now.gains = gainsFor(now, module);
        const Fields inFile = axisFields(file, id.part);
        Difference row{id, differing(inFile, axisFields(now, id.part))};
        row.scale = scaleOf(*id.module, module);
        if (isSent(id.part)) {
            row.applying = Applying::KeepsUnsent;
            if (module != nullptr)
                decideSending(row, inFile, file, *module);
        }
        add(std::move(row));
    }
    static void decideSending(Difference& row, const Fields& inFile, const AxisSettings& file,
                              const ModuleState& module) {
        std::vector<FieldDifference> toSend = differing(inFile, sentFields(module, row.id.part));
        if (inFile.empty() || toSend.empty()) {
            // The module has it already, or the file has nothing for it; what was sent is never taken back.
            row.applying = Applying::ChangesPanel;
            if (inFile.empty())
                row.fields.clear();
            return;
        }
        row.fields = std::move(toSend);
        row.refusal = whyNotSent(row.id.part, module);
        if (!row.refusal && intentOf(file, row.id.part, module))
            row.applying = Applying::Sends;
        row.wanted = !module.driveOn();
    }
    AxisScale scaleOf(ModuleIndex index, const ModuleState* module) const {
        const AxisSettings axis = m_now.axis(index);
        const AxisSettings file = m_file.axis(index);
        const bool step = module != nullptr ? module->info.identity.type == ModuleType::Stepper
                                            : file.expected && file.expected->type == ModuleType::Stepper;
        if (step)
            return AxisScale::step(axis.unit);
        return AxisScale::servo(axis.unit, module != nullptr ? module->servoRate : std::nullopt);
    }

    const Machine& m_file;
    const Machine& m_now;
    const std::vector<ModuleState>& m_modules;
    std::vector<Difference> m_rows;
};

void take(const PartId& id, const AxisSettings& from, AxisSettings& into) {
    switch (id.part) {
        case MachinePart::AxisName:
            into.name = from.name;
            break;
        case MachinePart::Unit:
            into.unit = from.unit;
            break;
        case MachinePart::Motion:
            into.motion = from.motion;
            break;
        case MachinePart::Travel:
            into.travel = from.travel;
            break;
        case MachinePart::Backlash:
            into.backlash = from.backlash;
            break;
        case MachinePart::Homing:
            into.homing = from.homing;
            break;
        case MachinePart::LimitStop:
            into.limitStop = from.limitStop;
            break;
        case MachinePart::Analog:
            into.analog = from.analog;
            break;
        case MachinePart::PinNames:
            into.outputNames = from.outputNames;
            into.inputNames = from.inputNames;
            into.pins = from.pins;
            break;
        case MachinePart::AccelerationTime:
            into.accelerationTime = from.accelerationTime;
            break;
        case MachinePart::Gains:
            into.gains = from.gains;
            break;
        case MachinePart::Io:
            into.io = from.io;
            into.fastPath = from.fastPath;
            break;
        case MachinePart::Parameters:
            into.parameters = from.parameters;
            break;
        case MachinePart::MachineName:
        case MachinePart::Rate:
        case MachinePart::Groups:
        case MachinePart::Program:
        case MachinePart::HomeOrder:
        case MachinePart::OperatorRights:
        case MachinePart::Hardware:
            break;
    }
}

void take(MachinePart part, const Machine& from, Machine& into) {
    if (part == MachinePart::MachineName)
        into.name = from.name;
    else if (part == MachinePart::Rate)
        into.baud = from.baud;
    else if (part == MachinePart::Groups)
        into.groups = from.groups;
    else if (part == MachinePart::Program)
        into.program = from.program;
    else if (part == MachinePart::HomeOrder)
        into.homeOrder = from.homeOrder;
    else if (part == MachinePart::OperatorRights)
        into.operatorRights = from.operatorRights;
}

void makeRoom(Machine& machine, std::size_t axes) {
    if (machine.axes.size() < axes)
        machine.axes.resize(axes);
}

bool saysNothing(AxisSettings axis) {
    axis.expected.reset();
    return axis == AxisSettings{};
}

/// The possible ones of these.
std::vector<Difference> chosenOf(std::vector<Difference> rows, const std::vector<PartId>& chosen) {
    std::erase_if(rows, [&chosen](const Difference& row) {
        return !row.possible() || std::find(chosen.begin(), chosen.end(), row.id) == chosen.end();
    });
    return rows;
}

}  // namespace

std::vector<Difference> compare(const Machine& file, const Machine& now,
                                const std::vector<ModuleState>& modules) {
    return Comparison(file, now, modules).rows();
}

Machine applied(const Machine& file, const Machine& now, const std::vector<ModuleState>& modules,
                const std::vector<PartId>& chosen) {
    Machine machine = now;
    for (const Difference& row : chosenOf(compare(file, now, modules), chosen))
        if (row.id.module) {
            makeRoom(machine, row.id.module->value() + std::size_t{1});
            take(row.id, file.axis(*row.id.module), machine.axes[row.id.module->value()]);
        } else
            take(row.id.part, file, machine);
    makeRoom(machine, file.axes.size());
    for (std::size_t i = 0; i < file.axes.size(); ++i)
        if (!forOther(file.axes[i], connected(modules, ModuleIndex(static_cast<std::uint8_t>(i)))))
            machine.axes[i].expected = file.axes[i].expected;
    // What the file does not have, and of which nothing else is known any more.
    while (machine.axes.size() > std::max(file.axes.size(), modules.size()) &&
           saysNothing(machine.axes.back()))
        machine.axes.pop_back();
    return machine;
}

std::vector<ModuleIntent> sendings(const Machine& file, const Machine& now,
                                   const std::vector<ModuleState>& modules,
                                   const std::vector<PartId>& chosen) {
    std::vector<ModuleIntent> intents;
    for (const Difference& row : chosenOf(compare(file, now, modules), chosen))
        if (row.applying == Applying::Sends)
            if (auto intent =
                    intentOf(file.axis(*row.id.module), row.id.part, *connected(modules, row.id.module)))
                intents.push_back({*row.id.module, std::move(*intent)});
    return intents;
}

Machine withChain(Machine machine, const std::vector<ModuleState>& modules, std::uint32_t baud) {
    makeRoom(machine, modules.size());
    for (std::size_t i = 0; i < modules.size(); ++i)
        if (!machine.axes[i].expected)
            machine.axes[i].expected = modules[i].info.identity;
    if (!modules.empty() && machine.baud == 0)
        machine.baud = baud;
    return machine;
}

}  // namespace nmc
