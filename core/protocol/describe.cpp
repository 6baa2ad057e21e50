// SPDX-License-Identifier: MIT
#include "protocol/describe.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include "protocol/baud.h"
#include "protocol/commandtable.h"
#include "protocol/frame.h"

namespace nmc {
namespace {

using Module = const ModuleIdentity&;

/// A list of phrases joined by a separator.
class Phrases {
public:
    explicit Phrases(std::string_view separator = ", ") : m_separator(separator) {}

    Phrases& add(std::string_view phrase) {
        if (!m_text.empty())
            m_text += m_separator;
        m_text += phrase;
        return *this;
    }
    Phrases& addIf(bool condition, std::string_view phrase) { return condition ? add(phrase) : *this; }
    [[nodiscard]] bool empty() const { return m_text.empty(); }
    [[nodiscard]] const std::string& text() const { return m_text; }

private:
    std::string m_text;
    std::string_view m_separator;
};

/// Returns "1 null" or "16 nulls", for example.
std::string counted(std::size_t count, std::string_view thing) {
    return std::to_string(count) + ' ' + std::string(thing) + (count == 1 ? "" : "s");
}

/// Returns the names of the lines whose bits are set, for example "IO1 IO12".
std::string lineNames(std::string_view name, unsigned count, unsigned bits, std::string_view none) {
    Phrases phrases(" ");
    for (unsigned line = 0; line < count; ++line)
        phrases.addIf((bits >> line & 1U) != 0, std::string(name) + std::to_string(line + 1));
    return phrases.empty() ? std::string(none) : phrases.text();
}

std::string itemNames(Module module, StatusItems items) {
    Phrases phrases;
    for (const StatusItemRow& row : statusItemTable(module))
        phrases.addIf(items.has(row.bit), row.name);
    // The data sheets call bits for which the chip has no item "clear to zero".
    const auto beyond = static_cast<std::uint8_t>(items.mask() & ~allItems(module).mask());
    if (beyond != 0)
        phrases.add("undefined " + toHex(std::array{beyond}));
    return phrases.empty() ? "status byte only" : phrases.text();
}

/// A 16.16 fixed-point number with six significant digits.
std::string fixedPoint(std::uint32_t value) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value / kFixedPointOne,
                                   std::chars_format::general, 6);
    return {text.data(), end.ptr};
}

/// The text that follows the name of a command; empty when the name says it all. This is a form of
/// commandform.h.
class Describer : public CommandForm {
public:
    explicit Describer(Module module) : m_module(module) {}

    void bit(unsigned /*number*/, bool value, std::string_view words = {}) {
        if (value)
            say(words);
    }
    void constant(std::uint8_t /*mask*/, std::uint8_t /*bits*/, std::string_view words = {}) { say(words); }
    template <typename Enum>
    void choice(std::uint8_t /*mask*/, Enum value, Choices<Enum> rows) {
        for (const auto& row : rows)
            if (row.value == value)
                say(row.words);
    }
    template <typename T>
    void number(std::string_view name, T value, ValueRange /*range*/ = kAnyValue) {
        constexpr bool kFixed = std::is_same_v<T, CountsPerTick> || std::is_same_v<T, CountsPerTickSquared>;
        if constexpr (kFixed)
            m_phrases.add(std::string(name) + ' ' + fixedPoint(value.value()));
        else
            m_phrases.add(std::string(name) + ' ' + std::to_string(rawValue(value)));
    }
    template <typename T>
    void optional(unsigned /*number*/, std::string_view name, const std::optional<T>& value,
                  ValueRange range = kAnyValue) {
        trailing(name, value, range);
    }
    template <typename T>
    void trailing(std::string_view name, const std::optional<T>& value, ValueRange /*range*/ = kAnyValue) {
        if (value)
            number(name, *value);
    }
    void lines(std::string_view words, std::string_view name, unsigned count, unsigned value) {
        m_phrases.add(std::string(words) + ' ' + lineNames(name, count, value, "none"));
    }
    void items(StatusItems items) { m_phrases.add(itemNames(m_module, items)); }
    void rate(std::uint8_t brd) {
        const auto row = std::ranges::find_if(
            kBaudRows, [&](const BaudRow& each) { return brd == each.brd || brd == each.dataSheetBrd; });
        const auto rate =
            row != std::end(kBaudRows) ? static_cast<long>(row->nominal) : std::lround(realRate(brd));
        number("code", brd);
        m_phrases.add(std::to_string(rate) + " Bd");
    }
    void group(BusAddress group, bool leader) {
        m_phrases.add("group " + toHex(std::array{group.value()})).add(leader ? "leader" : "member");
    }
    /// The duration of each point depends on the fast path bit, which is unknown here; the speeds do not.
    void pathPoints(const auto& words, std::size_t count) {
        if (count == 0)
            return say("start the path");
        Phrases speeds;
        for (const std::uint16_t word : std::span(words).first(count))
            speeds.add(((word & 1U) != 0 ? "-" : "") + fixedPoint((word & ~0x03U) << 8U) +
                       ((word & 2U) != 0 ? " long" : ""));
        m_phrases.add(counted(count, "point") + " at " + speeds.text());
    }
    void say(std::string_view words) { m_phrases.addIf(!words.empty(), words); }
    void orElse(std::string_view words) { m_phrases.addIf(m_phrases.empty(), words); }
    [[nodiscard]] const std::string& text() const { return m_phrases.text(); }

private:
    Module m_module;
    Phrases m_phrases;
};

template <typename... Commands>
std::string sentence(Module module, const std::variant<Commands...>& command) {
    const auto row = findCommand(module, encode(command).code);
    const std::string name(row ? row->name : "");
    Describer describer(module);
    std::visit([&](const auto& c) { c.fields(describer, c); }, command);
    return describer.text().empty() ? name : name + ": " + describer.text();
}

std::string describePayload(Module addressee, const Payload& payload) {
    // An unknown module is only sent commands that all modules have in common.
    const ModuleIdentity module = isKnown(addressee) ? addressee : kFirstServo;
    const auto row = findCommand(module, payload.code);
    const std::string data = payload.data.empty() ? "no data" : toHex(payload.data);
    if (!row)
        return "command " + std::to_string(static_cast<int>(payload.code)) +
               ", which the chip does not have: " + data;
    const auto text = withDecoded(module, payload, [&module](const auto& command) {
        return command ? std::optional(sentence(module, *command)) : std::nullopt;
    });
    return text ? *text : std::string(row->name) + ", not as the data sheet has it: " + data;
}

/// Returns the packet that the bytes begin with, cut short if the bytes end first.
ByteSpan firstPacket(ByteSpan bytes) {
    if (bytes.size() < 3)
        return bytes;
    const std::size_t length = (bytes[2] >> 4U) + std::size_t{4};
    return bytes.first(std::min(length, bytes.size()));
}

std::string describePacket(Module module, ByteSpan packet) {
    const auto frame = parsePacket(packet);
    if (frame)
        return describePayload(module, frame->payload);
    switch (frame.error()) {
        case FrameError::TooShort:
        case FrameError::LengthMismatch:
            return "cut packet";
        case FrameError::Checksum:
            return "packet with a wrong sum";
        case FrameError::NoHeader:
            break;
    }
    return "no packet";
}

using BitNames = std::array<std::string_view, 8>;

/// Returns the names of the bits that are set. The names of a PIC-STEP's bits contain spaces, so they are
/// joined with plus signs.
std::string bitNames(ModuleType type, const BitNames& names, std::uint8_t bits) {
    Phrases phrases(type == ModuleType::Stepper ? " + " : " ");
    for (unsigned i = 0; i < names.size(); ++i)
        if ((bits & (1U << i)) != 0)
            phrases.add(names[i].empty() ? "bit" + std::to_string(i) : std::string(names[i]));
    return phrases.empty() ? "00" : phrases.text();
}

const BitNames& statusBitNames(ModuleType type) {
    if (type == ModuleType::Stepper)
        return stepper::kStatusBitNames;
    return type == ModuleType::Io ? io::kStatusBitNames : servo::kStatusBitNames;
}

const BitNames& auxBitNames(const ModuleIdentity& module) {
    if (module.type == ModuleType::Stepper)
        return stepper::kInputBitNames;
    if (isSc(module))
        return servo::kScAuxBitNames;
    return hasPathBuffer(module) ? servo::kCmcAuxBitNames : servo::kAuxBitNames;
}

/// Items without named bits are shown as a number.
std::string valueOf(const ModuleIdentity& module, const StatusReport& report, const StatusItemRow& row) {
    const bool io = module.type == ModuleType::Io;
    if (!io && row.bit == StatusItems::Aux)
        return bitNames(module.type, auxBitNames(module), report.aux.value_or(0));
    std::string text;
    const auto describe = [&](const auto& value) {
        if (!value)
            return;
        using T = typename std::decay_t<decltype(value)>::value_type;
        if constexpr (std::is_same_v<T, ModuleIdentity>)
            text = "type " + std::to_string(static_cast<int>(value->type)) + ", version " +
                   std::to_string(value->version);
        else if (io && (row.bit == StatusItems::Pins || row.bit == StatusItems::LatchedPins))
            text = lineNames("IO", io::kPins, static_cast<std::uint16_t>(*value), "all low");
        else
            text = std::to_string(*value);
    };
    visitItem(row, describe, report);
    return text;
}

std::string describeReport(const ModuleIdentity& module, const StatusReport& report) {
    Phrases phrases;
    for (const StatusItemRow& row : statusItemTable(module)) {
        if (!report.items.has(row.bit))
            continue;
        const std::string value = valueOf(module, report, row);
        phrases.add(row.bit == StatusItems::Identity ? value : std::string(row.name) + ' ' + value);
    }
    const std::string bits = bitNames(module.type, statusBitNames(module.type), report.status);
    return phrases.add(report.status == 0 ? "status 00" : bits).text();
}

}  // namespace

std::string describeCommand(const ModuleIdentity& module, ByteSpan bytes) {
    Phrases parts("; ");
    while (!bytes.empty()) {
        // The modules skip any bytes in front of a header.
        const auto header = std::ranges::find(bytes, kHeader);
        const auto before = static_cast<std::size_t>(header - bytes.begin());
        if (before > 0) {
            const ByteSpan skipped = bytes.first(before);
            const bool nulls = std::ranges::all_of(skipped, [](std::uint8_t b) { return b == 0; });
            parts.add(counted(before, nulls ? "null" : "byte") + (nulls ? "" : " outside a packet"));
            bytes = bytes.subspan(before);
        } else {
            const ByteSpan packet = firstPacket(bytes);
            parts.add(describePacket(module, packet));
            bytes = bytes.subspan(packet.size());
        }
    }
    return parts.text();
}

std::string describeCommand(const ServoCommand& command) {
    // The SC has every command and every status item, so it can describe any of them.
    return sentence({ModuleType::Servo, kScVersion}, command);
}

std::string describeCommand(const StepperCommand& command) {
    return sentence({ModuleType::Stepper, 1}, command);
}

std::string describeCommand(const IoCommand& command) {
    return sentence({ModuleType::Io, 1}, command);
}

// ---- replies ----

std::string describeReply(const ModuleIdentity& module, StatusItems items, ByteSpan bytes) {
    if (bytes.empty())
        return {};
    const std::size_t length = replyLength(module, items);
    if (bytes.size() < length)
        return std::to_string(bytes.size()) + " of " + counted(length, "byte");
    Phrases phrases("; ");
    std::vector<std::uint8_t> reply(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(length));
    if (const std::uint8_t sum = sum8(ByteSpan(reply).first(length - 1)); sum != reply.back()) {
        phrases.add("sum " + toHex(std::array{reply.back()}) + " instead of " + toHex(std::array{sum}));
        reply.back() = sum;  // so that the contents can still be shown
    }
    if (const auto report = decodeStatus(module, items, reply))
        phrases.add(describeReport(module, *report));
    if (bytes.size() > length)
        phrases.add(counted(bytes.size() - length, "byte") + " too many");
    return phrases.text();
}

}  // namespace nmc
