// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>

#include "bus/exchangerecord.h"

namespace nmc {

/// What the packet monitor knows about the connection that it recorded.
struct PacketSession {
    std::string program;    ///< "NMC Panel 0.3.0"
    std::string startedAt;  ///< wall clock at `zero`, ISO 8601
    std::string port;       ///< as the user chose it
    bool simulated = false;
    TimePoint zero;  ///< what times are shown from
    bool operator==(const PacketSession&) const = default;
};

/// One exchange in the log.
struct PacketEntry {
    bus::ExchangeRecord record;
    bool afterGap = false;  ///< something between the entry before and this one was not recorded
};

/// What a row of the monitor is about; each record is of exactly one of the first four.
enum class PacketKind : std::uint8_t {
    Poll,
    Command,  ///< the operator's commands, held motion and what goes with them
    Stop,
    Link,  ///< connecting, challenges, flushes
};
[[nodiscard]] PacketKind kindOf(bus::Purpose purpose);

/// Whether something went wrong on the wire: not a stop that overtook, not a silence that was expected.
[[nodiscard]] bool wentWrong(const bus::ExchangeRecord& record);

/// What the user wants to see; empty means all.
struct PacketFilter {
    std::optional<ModuleIndex> module;
    std::optional<PacketKind> kind;
    bool onlyErrors = false;

    [[nodiscard]] bool passes(const bus::ExchangeRecord& record) const;
    bool operator==(const PacketFilter&) const = default;
};

/// The last exchanges of one connection, in bounded memory: when it is full, the oldest go and are counted.
/// A value; the GUI thread's.
class PacketLog {
public:
    static constexpr std::size_t kMaxEntries = 20'000;
    /// Of commands and replies together; a line full of noise must not fill the memory.
    static constexpr std::size_t kMaxBytes = 4U << 20U;
    /// Of one command or one reply; what is longer is cut off. The longest packet has 19 bytes.
    static constexpr std::size_t kMaxRecordBytes = 4'096;

    explicit PacketLog(std::size_t maxEntries = kMaxEntries, std::size_t maxBytes = kMaxBytes)
        : m_maxEntries(maxEntries), m_maxBytes(maxBytes) {}

    /// A new connection: what was recorded before is forgotten.
    void begin(PacketSession session);
    /// Forgets the entries, keeps the session.
    void clear();
    void append(bus::ExchangeRecord record);
    /// Recording was interrupted: the next entry says so.
    void interrupt() { m_interrupted = !m_entries.empty(); }

    [[nodiscard]] const PacketSession& session() const { return m_session; }
    [[nodiscard]] bool empty() const { return m_entries.empty(); }
    [[nodiscard]] std::size_t size() const { return m_entries.size(); }
    /// Entries are numbered from 0 in the order of append(); those below first() are gone.
    [[nodiscard]] std::uint64_t first() const { return m_first; }
    [[nodiscard]] std::uint64_t end() const { return m_first + m_entries.size(); }
    /// `number` in first()..end()-1.
    [[nodiscard]] const PacketEntry& at(std::uint64_t number) const { return m_entries[number - m_first]; }
    /// Gone because the log was full, since begin() or clear().
    [[nodiscard]] std::uint64_t dropped() const { return m_dropped; }

private:
    void dropFirst();

    PacketSession m_session;
    std::deque<PacketEntry> m_entries;
    std::size_t m_maxEntries;
    std::size_t m_maxBytes;
    std::size_t m_bytes = 0;
    std::uint64_t m_first = 0;
    std::uint64_t m_dropped = 0;
    std::uint64_t m_lastNumber = 0;  ///< the engine's number of the last entry
    bool m_interrupted = false;
};

/// Whom the command was sent to, by the bytes alone: "module 1", "address 3", "group FF"; "-" for nulls.
[[nodiscard]] std::string packetTarget(const bus::ExchangeRecord& record);
/// What the reply says (protocol/describe.h), or what is known of bytes that were not asked for.
[[nodiscard]] std::string packetReplyMeaning(const bus::ExchangeRecord& record);
/// Seconds from `zero` with six decimals: "12.034567".
[[nodiscard]] std::string packetTime(TimePoint time, TimePoint zero);

/// One line for people, without its end: time, target, rate, command, its meaning, reply, its meaning, and
/// the verdict, whose words come from the table of texts.
[[nodiscard]] std::string packetLine(const bus::ExchangeRecord& record, TimePoint zero,
                                     std::string_view verdict);

}  // namespace nmc
