// SPDX-License-Identifier: MIT
#include "model/machinefile/machinecompare.h"

#include <algorithm>
#include <array>

#include "model/intent/gainsplan.h"
#include "model/machinefile/fieldwriter.h"
#include "model/machinefile/machinegroups.h"
#include "model/module/modulescale.h"

namespace nmc {

namespace {

using Json = layout::FieldWriter::Json;
/// The values of one side of a comparison, in the member `file` of each; empty if nothing is set.
using Fields = std::vector<FieldDifference>;

/// The contents of a part: its keys in the writer's output, by which it is compared and listed, and the
/// members that are taken with it.
template <typename Whole>
struct PartMembers {
    MachinePart part;
    std::array<std::string_view, 3> keys;
    void (*take)(const Whole& from, Whole& into);
};

template <auto... Members, typename Whole>
void takeMembers(const Whole& from, Whole& into) {
    ((into.*Members = from.*Members), ...);
}

// In the order of display.
constexpr PartMembers<Machine> kMachineParts[] = {
    {MachinePart::MachineName, {"name"}, takeMembers<&Machine::name>},
    {MachinePart::Rate, {"rate_bd"}, takeMembers<&Machine::baud>},
    {MachinePart::Groups, {"groups"}, takeMembers<&Machine::groups>},
    {MachinePart::Program, {"points", "sequences"}, takeMembers<&Machine::program>},
    {MachinePart::HomeOrder, {"home_order"}, takeMembers<&Machine::homeOrder>},
    {MachinePart::OperatorRights, {"operator"}, takeMembers<&Machine::operatorRights>}};
constexpr PartMembers<AxisSettings> kAxisParts[] = {
    {MachinePart::AxisName, {"name"}, takeMembers<&AxisSettings::name>},
    {MachinePart::Unit, {"unit"}, takeMembers<&AxisSettings::unit>},
    {MachinePart::Motion, {"motion"}, takeMembers<&AxisSettings::motion>},
    {MachinePart::Travel, {"travel"}, takeMembers<&AxisSettings::travel>},
    {MachinePart::Backlash, {"backlash"}, takeMembers<&AxisSettings::backlash>},
    {MachinePart::Arrival, {"arrival"}, takeMembers<&AxisSettings::arrival>},
    {MachinePart::Homing, {"homing"}, takeMembers<&AxisSettings::homing>},
    {MachinePart::LimitStop, {"limit_stop"}, takeMembers<&AxisSettings::limitStop>},
    {MachinePart::WorkOffsets, {"work_offsets"}, takeMembers<&AxisSettings::workOffsets>},
    {MachinePart::Analog, {"analog"}, takeMembers<&AxisSettings::analog>},
    {MachinePart::PinNames,
     {"output_names", "input_names", "pins"},
     takeMembers<&AxisSettings::outputNames, &AxisSettings::inputNames, &AxisSettings::pins>},
    {MachinePart::Gains, {"gains"}, takeMembers<&AxisSettings::gains>},
    {MachinePart::Io, {"io", "sc_fast_path"}, takeMembers<&AxisSettings::io, &AxisSettings::fastPath>},
    {MachinePart::Parameters, {"parameters"}, takeMembers<&AxisSettings::parameters>},
    {MachinePart::AccelerationTime, {"acceleration_time"}, takeMembers<&AxisSettings::accelerationTime>}};

template <typename Whole, std::size_t Size>
void takePart(const PartMembers<Whole> (&parts)[Size], MachinePart part, const Whole& from, Whole& into) {
    for (const PartMembers<Whole>& members : parts)
        if (members.part == part)
            members.take(from, into);
}

/// Writes an axis with a servo's keys for any chip, and with all possible pins, so that both sides of a
/// comparison use the same names.
Json writtenAxis(AxisSettings axis) {
    axis.expected.reset();
    PinSettings& pins = axis.pins ? *axis.pins : axis.pins.emplace();
    pins.pins.resize(layout::kMaxPins);
    pins.pwm.resize(layout::kMaxPwm);
    pins.analog.resize(layout::kMaxAnalog);
    Json json = layout::written(axis);
    if (axis.fastPath)
        json["sc_fast_path"] = *axis.fastPath;  // a CMC has a "fast_path" among its limit pins
    return json;
}

/// Converts a value to a single text, so that any difference in it shows. Empty members are omitted.
std::string inOneText(const Json& value) {
    if (value.is_boolean())
        return value.get<bool>() ? "yes" : "no";
    if (value.is_number())
        return textOf(value.get<double>());
    if (value.is_string())
        return value.get<std::string>();
    std::string text;
    for (const auto& [key, member] : value.items())
        if (const std::string shown = inOneText(member); !shown.empty()) {
            text += text.empty() ? "" : member.is_object() ? "; " : ", ";
            text += (value.is_object() && key != "do" ? key + ' ' : std::string()) + shown;
        }
    return text;
}

/// The quantity indicated by the end of a key.
struct KeyEnding {
    std::string_view text;
    Quantity quantity;
};
constexpr KeyEnding kKeyEndings[] = {{layout::kServoSuffixes.distance, Quantity::Distance},
                                     {layout::kServoSuffixes.velocity, Quantity::Velocity},
                                     {layout::kServoSuffixes.acceleration, Quantity::Acceleration},
                                     {"_s", Quantity::Seconds}};

FieldDifference numberField(MachinePart part, std::string key, double number) {
    Quantity quantity = Quantity::Plain;
    for (const KeyEnding& ending : kKeyEndings)
        // Gains are the module's own numbers, whatever the unit of the axis.
        if (part != MachinePart::Gains && key.ends_with(ending.text)) {
            key.resize(key.size() - ending.text.size());
            quantity = ending.quantity;
        }
    if (part == MachinePart::Travel && quantity == Quantity::Distance)
        quantity = Quantity::Place;
    const bool zeroIsNumber = part != MachinePart::Rate && part != MachinePart::AccelerationTime &&
                              (quantity == Quantity::Plain || quantity == Quantity::Place);
    return {std::move(key), quantity,
            number != 0 || zeroIsNumber ? std::optional<FieldValue>(number) : std::nullopt};
}

FieldDifference textField(std::string key, const std::string& text) {
    return {std::move(key), Quantity::Plain, text.empty() ? std::nullopt : std::optional<FieldValue>(text)};
}

/// A list whose items are separate fields: how they are called, and the member that identifies them; without
/// one, it is their index.
struct ItemKey {
    std::string_view list;
    std::string_view called;
    std::string by{};
};
const ItemKey kItemKeys[] = {{"points", "point ", "name"},
                             {"sequences", "sequence ", "name"},
                             {"output_names", "output"},
                             {"input_names", "input"},
                             {"pins", "IO"},
                             {"pwm", "PWM"},
                             {"analog", "AD"}};

/// A pin that the user has not set has no name, and its flags are off.
bool saysNothing(const Json& item) {
    return item.is_object() && std::ranges::all_of(item, [](const Json& member) {
               return member == false || inOneText(member).empty();
           });
}

void addItems(Fields& fields, const ItemKey& naming, const Json& items) {
    for (std::size_t i = 0; i < items.size(); ++i) {
        Json rest = items[i];
        const bool named = !naming.by.empty();
        const std::string key =
            std::string(naming.called) + (named ? inOneText(rest[naming.by]) : std::to_string(i + 1));
        if (rest.is_object()) {
            rest.erase(naming.by);
            rest.erase("scale");
        }
        // A single member is not labelled, and a named item is listed even if it contains nothing else.
        const std::string text = saysNothing(rest) ? "" : inOneText(rest.size() == 1 ? rest.front() : rest);
        fields.push_back(textField(key, named && text.empty() ? "-" : text));
        if (items[i].contains("scale"))
            fields.push_back(textField(key + " scale", inOneText(items[i]["scale"])));
    }
}

/// Uses no words of the file, so that the table can express it in the user's language.
void addGroup(Fields& fields, const Json& group) {
    const std::string address = inOneText(group["address"]);
    const std::string name = inOneText(group["name"]);
    const std::string members = inOneText(group["modules"]);
    fields.push_back({"group" + address, Quantity::Plain, name.empty() ? members : name + ": " + members});
    if (group.contains("leader"))
        fields.push_back({"leader" + address, Quantity::Plain, group["leader"].get<double>()});
}

void addFields(Fields& fields, MachinePart part, const std::string& key, const Json& value) {
    const auto* naming = std::ranges::find(kItemKeys, key, &ItemKey::list);
    if (value.is_object())
        for (const auto& [name, member] : value.items())
            addFields(fields, part, name, member);
    else if (value.is_array() && naming != std::end(kItemKeys))
        addItems(fields, *naming, value);
    else if (key == "groups")
        for (const Json& group : value)
            addGroup(fields, group);
    else if (key == "work_offsets")
        for (const Json& offset : value)
            fields.push_back(
                {"offset " + inOneText(offset["name"]), Quantity::Place, offset["from_home"].get<double>()});
    else if (value.is_number())
        fields.push_back(numberField(part, key, value.get<double>()));
    else if (value.is_boolean())
        fields.push_back({key, Quantity::Plain, value.get<bool>()});
    else
        fields.push_back(textField(key, inOneText(value)));
}

template <typename Whole>
Fields fieldsOf(const PartMembers<Whole>& members, const Json& whole) {
    Fields fields;
    for (const std::string_view key : members.keys)
        if (const auto found = whole.find(std::string(key)); found != whole.end())
            addFields(fields, members.part, std::string(key), *found);
    return fields;
}

Fields differing(Fields fields, const Fields& now) {
    for (const FieldDifference& other : now) {
        auto same = std::ranges::find(fields, other.key, &FieldDifference::key);
        if (same == fields.end())
            same = fields.insert(same, {other.key, other.quantity});
        same->now = other.file;
    }
    std::erase_if(fields, [](const FieldDifference& field) { return field.file == field.now; });
    return fields;
}

// ---- axes and their modules ----

/// True if an axis of the file meets a module for which it is not intended.
bool forOther(const AxisSettings& axis, const ModuleState* module) {
    return module != nullptr && axis.expected && *axis.expected != module->info.identity;
}

/// True if the two are for different types of module, so that no number of one fits the other.
bool differInType(const AxisSettings& file, const AxisSettings& now) {
    return now.expected && isOtherType(file.expected, *now.expected);
}

/// The axis with the gains that this module takes.
AxisSettings asTaken(AxisSettings axis, const ModuleState* module) {
    if (axis.gains && module != nullptr)
        axis.gains = gainsFor(*module, *axis.gains);
    return axis;
}

/// What the module was sent in this connection; missing values are unknown.
AxisSettings sentTo(const ModuleState& module) {
    AxisSettings sent;
    sent.gains = module.gains;
    sent.io = module.io;
    if (module.scIo)
        sent.fastPath = module.scIo->fastPath;
    sent.parameters = module.stepper.parameters;
    return sent;
}

bool isSent(MachinePart part) {
    return part == MachinePart::Gains || part == MachinePart::Io || part == MachinePart::Parameters;
}

std::optional<Intent> intentOf(const AxisSettings& axis, MachinePart part, const ModuleState& module) {
    if (part == MachinePart::Gains && axis.gains)
        return intent::ApplyGains{*axis.gains};
    if (part == MachinePart::Parameters && axis.parameters)
        return stepperintent::SetParameters{*axis.parameters};
    if (part != MachinePart::Io)
        return std::nullopt;
    if (!isSc(module.info.identity))
        return axis.io ? std::optional<Intent>(intent::ControlIo{*axis.io}) : std::nullopt;
    // I/O Control of an SC sets every bit, so it is not sent while the others are unknown.
    if (!axis.fastPath || !module.scIo)
        return std::nullopt;
    servo::ScIoControl io = *module.scIo;
    io.fastPath = *axis.fastPath;
    return intent::ControlSc{io};
}

std::optional<Refusal> whyNotSent(MachinePart part, const ModuleState& module) {
    if (part == MachinePart::Gains)
        return whyNot(IntentKind::ApplyGains, module);
    if (part == MachinePart::Parameters)
        return whyNot(IntentKind::SetParameters, module);
    return whyNot(isSc(module.info.identity) ? IntentKind::ControlSc : IntentKind::ControlIo, module);
}

/// Uses the words of the file, for the table.
std::optional<FieldValue> identityText(const std::optional<ModuleIdentity>& identity) {
    if (!identity)
        return std::nullopt;
    const Json json = layout::written(*identity);
    return (json["type"].is_number() ? "type " : "") + inOneText(json["type"]) + " v" +
           inOneText(json["version"]);
}

/// The difference between the module in the file and the one in the chain or, if that is none or nothing is
/// connected, the type that the axis is for now; empty if there is none.
std::optional<Difference> hardwareDifference(ModuleIndex index, const Machine& file, const Machine& now,
                                             const std::vector<ModuleState>& modules) {
    const ModuleState* module = moduleAt(index, modules);
    const bool inFile = index.value() < file.axes.size();
    Difference row{{index, MachinePart::Hardware}, {}};
    row.wanted = false;
    if (module != nullptr && !inFile)
        row.applying = Applying::NotInFile;
    else if (module == nullptr && inFile && !modules.empty())
        row.applying = Applying::NotThere;
    else if (forOther(file.axis(index), module))
        row.applying = Applying::OtherHardware;
    else if (differInType(file.axis(index), now.axis(index)))
        row.wanted = true;
    else
        return std::nullopt;
    const auto present = module != nullptr ? std::optional(module->info.identity) : std::nullopt;
    row.fields = {{"hardware", Quantity::Plain, identityText(file.axis(index).expected),
                   identityText(row.possible() ? now.axis(index).expected : present)}};
    return row;
}

void compareAxis(std::vector<Difference>& rows, ModuleIndex index, const AxisSettings& file,
                 const AxisSettings& now, const ModuleState* module) {
    const Json fileJson = writtenAxis(file);
    const Json nowJson = writtenAxis(now);
    const Json sentJson = writtenAxis(module != nullptr ? sentTo(*module) : AxisSettings{});
    for (const PartMembers<AxisSettings>& members : kAxisParts) {
        const Fields inFile = fieldsOf(members, fileJson);
        Difference row{{index, members.part}, differing(inFile, fieldsOf(members, nowJson))};
        row.scale = scaleOf(module, now, file.expected);
        if (isSent(members.part) && module == nullptr)
            row.applying = Applying::KeepsUnsent;
        else if (isSent(members.part) && inFile.empty())
            continue;  // the file has no value for it, and what was sent is never revoked
        else if (isSent(members.part))
            if (Fields toSend = differing(inFile, fieldsOf(members, sentJson)); !toSend.empty()) {
                row.fields = std::move(toSend);
                row.refusal = whyNotSent(members.part, *module);
                row.applying = !row.refusal && intentOf(file, members.part, *module) ? Applying::Sends
                                                                                     : Applying::KeepsUnsent;
                row.wanted = !module->driveOn();
            }
        if (!row.fields.empty())
            rows.push_back(std::move(row));
    }
}

void makeRoom(Machine& machine, std::size_t axes) {
    if (machine.axes.size() < axes)
        machine.axes.resize(axes);
}

bool isUnset(AxisSettings axis) {
    axis.expected.reset();
    return axis == AxisSettings{};
}

bool isAmong(const std::vector<Difference>& rows, const PartId& part) {
    return std::ranges::find(rows, part, &Difference::id) != rows.end();
}

/// True if there is a row of this axis.
bool has(const std::vector<Difference>& rows, ModuleIndex axis) {
    return std::ranges::any_of(rows, [axis](const Difference& row) { return row.id.module == axis; });
}

/// Removes the axes that are for another type of module than in `from`, from which the points are.
void leavePoints(Machine& machine, const Machine& from, const std::vector<ModuleState>& modules) {
    for (Point& point : machine.program.points)
        std::erase_if(point.axes, [&](const PointAxis& place) {
            auto expected = machine.axis(place.module).expected;
            if (const ModuleState* module = moduleAt(place.module, modules); module != nullptr && !expected)
                expected = module->info.identity;
            return expected && isOtherType(from.axis(place.module).expected, *expected);
        });
}

/// Keeps the chosen rows that are possible.
std::vector<Difference> chosenOf(std::vector<Difference> rows, const std::vector<PartId>& chosen) {
    std::erase_if(rows, [&chosen](const Difference& row) {
        return !row.possible() || std::ranges::find(chosen, row.id) == chosen.end();
    });
    return rows;
}

}  // namespace

std::vector<Difference> compare(const Machine& file, const Machine& now,
                                const std::vector<ModuleState>& modules) {
    std::vector<Difference> rows;
    const Json fileJson = layout::written(file);
    const Json nowJson = layout::written(now);
    for (const PartMembers<Machine>& members : kMachineParts) {
        const Fields inFile = fieldsOf(members, fileJson);
        const bool sends = members.part == MachinePart::Groups && !groupChanges(file, modules).empty();
        Fields fields = differing(inFile, fieldsOf(members, nowJson));
        if (fields.empty() && sends)
            fields = inFile;  // the modules have lost them, in a restart for example
        if (fields.empty())
            continue;
        rows.push_back({{{}, members.part}, std::move(fields)});
        if (sends)
            rows.back().applying = Applying::Sends;
    }
    const std::size_t axes = std::max({file.axes.size(), now.axes.size(), modules.size()});
    for (std::size_t i = 0; i < axes; ++i) {
        const ModuleIndex index(static_cast<std::uint8_t>(i));
        const ModuleState* module = moduleAt(index, modules);
        const std::optional<Difference> hardware = hardwareDifference(index, file, now, modules);
        if (hardware)
            rows.push_back(*hardware);
        if (!hardware || hardware->possible() || hardware->applying == Applying::NotThere)
            compareAxis(rows, index, asTaken(file.axis(index), module), asTaken(now.axis(index), module),
                        module);
    }
    return rows;
}

bool stillHold(const std::vector<Difference>& shown, const std::vector<Difference>& now,
               const std::vector<PartId>& chosen) {
    return chosenOf(shown, chosen) == chosenOf(now, chosen);
}

Machine applied(const Machine& file, const Machine& now, const std::vector<ModuleState>& modules,
                const std::vector<PartId>& chosen) {
    Machine machine = now;
    std::vector<Difference> rows = compare(file, now, modules);
    const std::vector<Difference> taken = chosenOf(rows, chosen);
    for (const Difference& row : taken)
        if (row.id.module) {
            makeRoom(machine, row.id.module->value() + std::size_t{1});
            takePart(kAxisParts, row.id.part, file.axis(*row.id.module),
                     machine.axes[row.id.module->value()]);
        } else
            takePart(kMachineParts, row.id.part, file, machine);
    std::erase_if(rows, [&taken](const Difference& row) {
        return !row.possible() || isAmong(taken, row.id);  // what is left was not chosen
    });
    makeRoom(machine, file.axes.size());
    for (std::size_t i = 0; i < file.axes.size(); ++i) {
        const ModuleIndex index(static_cast<std::uint8_t>(i));
        AxisSettings& axis = machine.axes[i];
        if (forOther(file.axes[i], moduleAt(index, modules)))
            continue;
        if (!differInType(file.axes[i], now.axis(index))) {
            if (file.axes[i].expected || !has(rows, index))
                axis.expected = file.axes[i].expected;
        } else if (has(taken, index)) {
            axis = file.axes[i];
            for (const Difference& row : rows)
                if (row.id.module == index)
                    takePart(kAxisParts, row.id.part, usable(now.axis(index), *axis.expected), axis);
        }
    }
    const PartId program{{}, MachinePart::Program};
    if (isAmong(taken, program) || isAmong(rows, program))
        leavePoints(machine, isAmong(taken, program) ? file : now, modules);
    // Drops axes that are neither in the file nor connected, and of which nothing else is known any more.
    while (machine.axes.size() > std::max(file.axes.size(), modules.size()) && isUnset(machine.axes.back()))
        machine.axes.pop_back();
    return machine;
}

std::vector<ModuleIntent> sendings(const Machine& file, const Machine& now,
                                   const std::vector<ModuleState>& modules,
                                   const std::vector<PartId>& chosen) {
    std::vector<ModuleIntent> intents;
    for (const Difference& row : chosenOf(compare(file, now, modules), chosen))
        if (row.applying == Applying::Sends && row.id.module)
            if (auto intent =
                    intentOf(file.axis(*row.id.module), row.id.part, *moduleAt(*row.id.module, modules)))
                intents.push_back({*row.id.module, std::move(*intent)});
    return intents;
}

Machine withChain(Machine machine, const std::vector<ModuleState>& modules, std::uint32_t baud) {
    makeRoom(machine, modules.size());
    for (std::size_t i = 0; i < modules.size(); ++i)
        if (!machine.axes[i].expected && modules[i].info.identity != kUnheardModule)
            machine.axes[i].expected = modules[i].info.identity;
    if (!modules.empty() && machine.baud == 0)
        machine.baud = baud;
    return machine;
}

}  // namespace nmc
