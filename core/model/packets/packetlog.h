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

/// Information about the connection that the packet monitor recorded.
struct PacketSession {
    std::string program;    ///< "NMC Panel 0.3.0"
    std::string startedAt;  ///< wall clock at `zero`, ISO 8601
    std::string port;       ///< as chosen by the user
    bool simulated = false;
    TimePoint zero;  ///< the origin of displayed times
    bool operator==(const PacketSession&) const = default;
};

/// One exchange in the log.
struct PacketEntry {
    bus::ExchangeRecord record;
    bool afterGap = false;  ///< one or more exchanges between the previous entry and this one were not
                            ///< recorded
};

/// The subject of a row in the monitor; every record belongs to exactly one of the four.
enum class PacketKind : std::uint8_t {
    Poll,
    Command,  ///< the user's commands, held motion and what belongs to them
    Stop,
    Link,  ///< connecting, challenges, flushes
};
[[nodiscard]] PacketKind kindOf(bus::Purpose purpose);

/// True when something went wrong on the line; a stop that overtook an exchange, or an expected silence, does
/// not count.
[[nodiscard]] bool wentWrong(const bus::ExchangeRecord& record);

/// What the user wants to see; empty means everything.
struct PacketFilter {
    std::optional<ModuleIndex> module;
    std::optional<PacketKind> kind;
    bool onlyErrors = false;

    [[nodiscard]] bool passes(const bus::ExchangeRecord& record) const;
    bool operator==(const PacketFilter&) const = default;
};

/// The latest exchanges of one connection, in bounded memory: when it is full, the oldest are discarded and
/// counted. A value type; belongs to the GUI thread.
class PacketLog {
public:
    static constexpr std::size_t kMaxEntries = 20'000;
    /// Total size of commands and replies; a line full of noise must not fill the memory.
    static constexpr std::size_t kMaxBytes = 4U << 20U;
    /// Maximum size of one command or reply; longer ones are cut. The longest packet has 19 bytes.
    static constexpr std::size_t kMaxRecordBytes = 4'096;

    explicit PacketLog(std::size_t maxEntries = kMaxEntries, std::size_t maxBytes = kMaxBytes)
        : m_maxEntries(maxEntries), m_maxBytes(maxBytes) {}

    /// Starts a new connection and discards what was recorded before.
    void begin(PacketSession session);
    /// Discards the entries but keeps the session.
    void clear();
    void append(bus::ExchangeRecord record);
    /// Notes that recording was interrupted; the next entry is marked accordingly.
    void interrupt() { m_interrupted = !m_entries.empty(); }

    [[nodiscard]] const PacketSession& session() const { return m_session; }
    [[nodiscard]] bool empty() const { return m_entries.empty(); }
    [[nodiscard]] std::size_t size() const { return m_entries.size(); }
    /// Entries are numbered from 0 in the order of append(); those below first() have been discarded.
    [[nodiscard]] std::uint64_t first() const { return m_first; }
    [[nodiscard]] std::uint64_t end() const { return m_first + m_entries.size(); }
    /// `number` must be in first()..end()-1.
    [[nodiscard]] const PacketEntry& at(std::uint64_t number) const { return m_entries[number - m_first]; }
    /// The number of entries discarded because the log was full, since begin() or clear().
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

/// The addressee of a command, from its bytes alone: "module 1", "address 3", "group FF"; "-" for nulls.
[[nodiscard]] std::string packetTarget(const bus::ExchangeRecord& record);
/// The meaning of the reply (protocol/describe.h), or what is known about bytes that were not requested.
[[nodiscard]] std::string packetReplyMeaning(const bus::ExchangeRecord& record);
/// Seconds since `zero` with six decimals: "12.034567".
[[nodiscard]] std::string packetTime(TimePoint time, TimePoint zero);

/// One line for people, without a line end: time, target, rate, command and its meaning, reply and its
/// meaning, and the verdict, whose words come from the table of texts.
[[nodiscard]] std::string packetLine(const bus::ExchangeRecord& record, TimePoint zero,
                                     std::string_view verdict);

}  // namespace nmc
