// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <initializer_list>
#include <limits>
#include <optional>
#include <string_view>

#include "protocol/frame.h"
#include "protocol/moduletype.h"
#include "protocol/status.h"

/// A command defines its contents once: kCode, and `fields(form, command)`, which presents each field to a
/// form. PayloadWriter, PayloadReader and the describer in describe.cpp are such forms. Values appear in the
/// order in which they are sent, least significant byte first; all bits belong to one control byte, which is
/// sent first, and may appear in any order.
namespace nmc {

/// An inclusive range from a data sheet.
struct ValueRange {
    std::int64_t min;
    std::int64_t max;
    [[nodiscard]] constexpr bool contains(std::int64_t value) const { return value >= min && value <= max; }
};

inline constexpr ValueRange kAnyValue{std::numeric_limits<std::int64_t>::min(),
                                      std::numeric_limits<std::int64_t>::max()};
inline constexpr std::uint8_t kLastVersion = 255;

/// One value of an enum, as bits of the control byte.
template <typename Enum>
struct Choice {
    Enum value;
    std::uint8_t bits;
    std::string_view words = {};
};
template <typename Enum>
using Choices = std::initializer_list<Choice<std::remove_const_t<Enum>>>;

template <typename T>
[[nodiscard]] constexpr auto rawValue(const T& value) {
    if constexpr (requires { value.value(); })
        return value.value();
    else
        return value;
}

/// What only some forms need; the others inherit it.
struct CommandForm {
    static constexpr bool kReads = false;
    /// True when the module has one of these versions. Used for fields that other versions ignore.
    [[nodiscard]] bool ofVersions(std::uint8_t /*first*/, std::uint8_t /*last*/ = kLastVersion) const {
        return true;
    }
    void check(bool /*condition*/) {}
    void ignoreRest(std::size_t /*most*/) {}
    void say(std::string_view /*words*/) {}
    void orElse(std::string_view /*words*/) {}
};

class PayloadWriter : public CommandForm {
public:
    explicit PayloadWriter(CommandCode code) : m_code(code) {}

    void bit(unsigned number, bool value, std::string_view /*words*/ = {}) {
        constant(0, value ? static_cast<std::uint8_t>(1U << number) : std::uint8_t{0});
    }
    void constant(std::uint8_t /*mask*/, std::uint8_t bits, std::string_view /*words*/ = {}) {
        m_control = static_cast<std::uint8_t>(m_control.value_or(0) | bits);
    }
    template <typename Enum>
    void choice(std::uint8_t /*mask*/, Enum value, Choices<Enum> rows) {
        for (const auto& row : rows)
            if (row.value == value)
                constant(0, row.bits);
    }
    template <typename T>
    void number(std::string_view /*name*/, T value, ValueRange /*range*/ = kAnyValue) {
        m_values.appendLittleEndian(rawValue(value));
    }
    /// A value whose presence a control bit announces.
    template <typename T>
    void optional(unsigned number, std::string_view name, const std::optional<T>& value,
                  ValueRange range = kAnyValue) {
        bit(number, value.has_value());
        trailing(name, value, range);
    }
    /// A value that is present when the command is longer.
    template <typename T>
    void trailing(std::string_view name, const std::optional<T>& value, ValueRange range = kAnyValue) {
        if (value)
            this->number(name, *value, range);
    }
    /// `count` inputs or outputs named name1, name2 and so on; bit 0 is the first.
    template <typename T>
    void lines(std::string_view /*words*/, std::string_view /*name*/, unsigned count, T value) {
        number({}, static_cast<T>(value & ((1U << count) - 1U)));
    }
    void items(StatusItems items) { number({}, items.mask()); }
    void rate(std::uint8_t brd) { number({}, brd); }
    void group(BusAddress group, bool leader) {
        number({}, static_cast<std::uint8_t>(leader ? group.value() & 0x7FU : group.value() | 0x80U));
    }
    void pathPoints(const auto& words, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i)
            number({}, words[i]);
    }

    [[nodiscard]] Payload payload() const {
        Payload payload{m_code, {}};
        if (m_control)
            payload.data.push_back(*m_control);
        payload.data.append(m_values);
        return payload;
    }

private:
    CommandCode m_code;
    std::optional<std::uint8_t> m_control;
    DataBytes m_values;
};

class PayloadReader : public CommandForm {
public:
    static constexpr bool kReads = true;
    PayloadReader(ByteSpan data, const ModuleIdentity& module) : m_module(module), m_rest(data) {}
    [[nodiscard]] bool ofVersions(std::uint8_t first, std::uint8_t last = kLastVersion) const {
        return m_module.version >= first && m_module.version <= last;
    }

    void bit(unsigned number, bool& value, std::string_view /*words*/ = {}) {
        value = (unsigned{control()} >> number & 1U) != 0;
    }
    void constant(std::uint8_t mask, std::uint8_t bits, std::string_view /*words*/ = {}) {
        check((control() & mask) == bits);
    }
    template <typename Enum>
    void choice(std::uint8_t mask, Enum& value, Choices<Enum> rows) {
        bool found = false;
        for (const auto& row : rows)
            if (row.bits == (control() & mask)) {
                value = row.value;
                found = true;
            }
        check(found);
    }
    template <typename T>
    void number(std::string_view /*name*/, T& value, ValueRange range = kAnyValue) {
        using Raw = decltype(rawValue(value));
        if (m_rest.size() < sizeof(Raw))
            return check(false);
        value = T(readLittleEndian<Raw>(m_rest));
        m_rest = m_rest.subspan(sizeof(Raw));
        check(range.contains(rawValue(value)));
    }
    template <typename T>
    void optional(unsigned number, std::string_view name, std::optional<T>& value,
                  ValueRange range = kAnyValue) {
        bool there = false;
        bit(number, there);
        if (there)
            this->number(name, value.emplace(), range);
    }
    template <typename T>
    void trailing(std::string_view name, std::optional<T>& value, ValueRange range = kAnyValue) {
        if (!m_rest.empty())
            number(name, value.emplace(), range);
    }
    template <typename T>
    void lines(std::string_view /*words*/, std::string_view name, unsigned count, T& value) {
        number(name, value);
        value = static_cast<T>(value & ((1U << count) - 1U));
    }
    void items(StatusItems& items) {
        std::uint8_t mask = 0;
        number({}, mask);
        items = StatusItems(mask);
    }
    void rate(std::uint8_t& brd) { number({}, brd); }
    void group(BusAddress& group, bool& leader) {
        std::uint8_t byte = 0;
        number({}, byte);
        group = BusAddress(static_cast<std::uint8_t>(byte | 0x80U));
        leader = (byte & 0x80U) == 0;
    }
    template <typename Count>
    void pathPoints(auto& words, Count& count) {
        for (count = 0; !m_rest.empty() && m_right; ++count) {
            if (count == words.size())
                return check(false);
            number({}, words[count]);
        }
    }
    void check(bool condition) { m_right = m_right && condition; }
    /// Skips up to `most` bytes that the chip accepts but does not read.
    void ignoreRest(std::size_t most) {
        if (m_rest.size() <= most)
            m_rest = {};
    }

    /// True if all data was read, and is as the data sheet has it.
    [[nodiscard]] bool right() const { return m_right && m_rest.empty(); }

private:
    std::uint8_t control() {
        if (!m_control) {
            std::uint8_t byte = 0;
            number({}, byte);
            m_control = byte;
        }
        return *m_control;
    }

    ModuleIdentity m_module;
    ByteSpan m_rest;
    std::optional<std::uint8_t> m_control;
    bool m_right = true;
};

/// The actions of Set Homing Mode when home is found, the same on a PIC-SERVO and a PIC-STEP. At most one of
/// the three may be set.
void homingStopFields(auto& form, auto& c) {
    form.bit(2, c.motorOff, "motor off");
    form.bit(4, c.stopAbruptly, "stop abruptly");
    form.bit(5, c.stopSmoothly, "stop smoothly");
    form.check(int{c.motorOff} + int{c.stopAbruptly} + int{c.stopSmoothly} <= 1);
    form.orElse("cancel");
}

/// A command that is no more than its code.
template <CommandCode Code>
struct CommandWithoutData {
    static constexpr CommandCode kCode = Code;
    static void fields(auto& /*form*/, auto& /*c*/) {}
    bool operator==(const CommandWithoutData&) const = default;
};

template <typename Command>
concept HasFields = requires {
    Command::kCode;
};

template <HasFields Command>
[[nodiscard]] Payload encode(const Command& command) {
    PayloadWriter writer(Command::kCode);
    Command::fields(writer, command);
    return writer.payload();
}

/// The last version covered by the first data sheet.
inline constexpr ModuleIdentity kFirstServo{ModuleType::Servo, 4};

/// Decodes the bytes as a module of that version does; fields that only later versions read are ignored.
/// Returns nothing if the code is another, the control byte or the command calls for a different number of
/// data bytes, or a value is outside the data sheet's range.
template <HasFields Command>
[[nodiscard]] std::optional<Command> decode(const Payload& payload,
                                            const ModuleIdentity& module = kFirstServo) {
    if (payload.code != Command::kCode)
        return std::nullopt;
    Command command;
    PayloadReader reader(payload.data, module);
    Command::fields(reader, command);
    return reader.right() ? std::optional(command) : std::nullopt;
}

}  // namespace nmc
