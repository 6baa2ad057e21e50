// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/packetfilereader.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <utility>

#include "model/packets/packetwords.h"

namespace nmc {

namespace {

constexpr std::string_view kMagic = "# nmcpanel packet log 1";
constexpr std::string_view kColumns =
    "# time_us took_us purpose module baud type:items verdict >command <reply";
constexpr std::string_view kGap = "gap";
constexpr std::size_t kMaxHeaderText = 500;
constexpr std::size_t kFields = 9;
/// Ten years; anything longer is damage, and would overflow.
constexpr std::int64_t kMaxMicroseconds = 315'360'000'000'000;

template <typename T>
std::optional<T> number(std::string_view text, int base = 10) {
    T value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
    if (error != std::errc{} || end != text.data() + text.size())
        return std::nullopt;
    return value;
}

/// What is wrong, as a sentence without its full stop; empty if nothing is.
using Complaint = std::optional<std::string>;

std::optional<std::vector<std::uint8_t>> bytesOf(std::string_view text) {
    if (text.size() % 2 != 0)
        return std::nullopt;
    std::vector<std::uint8_t> bytes;
    bytes.reserve(text.size() / 2);
    for (std::size_t i = 0; i < text.size(); i += 2) {
        const auto byte = number<std::uint8_t>(text.substr(i, 2), 16);
        if (!byte)
            return std::nullopt;
        bytes.push_back(*byte);
    }
    return bytes;
}

std::optional<Duration> durationOf(std::string_view text) {
    const std::size_t point = text.find('.');
    if (point == std::string_view::npos || text.size() - point != 4 || text.front() == '-')
        return std::nullopt;
    const auto whole = number<std::int64_t>(text.substr(0, point));
    const auto fraction = number<std::uint16_t>(text.substr(point + 1));
    if (!whole || !fraction || *whole > kMaxMicroseconds)
        return std::nullopt;
    return Duration(*whole * 1'000 + *fraction);
}

template <typename Enum, std::size_t Size>
std::optional<Enum> wordOf(const std::array<std::string_view, Size>& table, std::string_view text) {
    const auto found = std::find(table.begin(), table.end(), text);
    if (found == table.end())
        return std::nullopt;
    return static_cast<Enum>(found - table.begin());
}

Complaint readModule(std::string_view text, bus::ExchangeRecord& record) {
    if (text == "-")
        return std::nullopt;
    const auto module = number<std::uint8_t>(text);
    if (!module || *module == 0)
        return "the module is neither a number from 1 to 255 nor -";
    record.module = ModuleIndex(static_cast<std::uint8_t>(*module - 1));
    return std::nullopt;
}

Complaint readLayout(std::string_view text, bus::ExchangeRecord& record) {
    const std::size_t colon = text.find(':');
    if (colon == std::string_view::npos)
        return "the layout of the reply has no colon";
    const std::size_t dot = std::min(text.find('.'), colon);
    const auto type = number<std::uint8_t>(text.substr(0, dot));
    const auto version =
        dot < colon ? number<std::uint8_t>(text.substr(dot + 1, colon - dot - 1)) : std::uint8_t{0};
    const auto items = bytesOf(text.substr(colon + 1));
    if (!type || !version || !items || items->size() != 1)
        return "the layout of the reply is not a type number and a mask of two hexadecimal digits";
    record.layout = {{static_cast<ModuleType>(*type), *version}, StatusItems(items->front())};
    return std::nullopt;
}

Complaint readVerdict(std::string_view text, bus::ExchangeRecord& record) {
    const std::size_t colon = text.find(':');
    const auto end = wordOf<bus::ReplyResult>(words::kEnds, text.substr(0, colon));
    if (!end)
        return "the verdict is not known";
    record.end = *end;
    if (colon == std::string_view::npos)
        return std::nullopt;
    record.rejection = wordOf<bus::Rejection>(words::kRejections, text.substr(colon + 1));
    if (*end != bus::ReplyResult::Rejected || !record.rejection)
        return "the rule behind the verdict is not known";
    return std::nullopt;
}

Complaint readBytes(std::string_view text, char direction, std::string_view what,
                    std::vector<std::uint8_t>& into) {
    if (text.empty() || text.front() != direction)
        return "the " + std::string(what) + " does not begin with " + direction;
    auto bytes = bytesOf(text.substr(1));
    if (!bytes)
        return "the " + std::string(what) + " is not hexadecimal";
    if (bytes->size() > PacketLog::kMaxRecordBytes)
        return "the " + std::string(what) + " is longer than " + std::to_string(PacketLog::kMaxRecordBytes) +
               " bytes";
    into = std::move(*bytes);
    return std::nullopt;
}

Complaint readTimes(std::string_view time, std::string_view took, bus::ExchangeRecord& record) {
    const auto sent = durationOf(time);
    const auto lasted = durationOf(took);
    if (!sent || !lasted)
        return "a time is not microseconds with three decimals";
    record.sent = TimePoint(*sent);
    record.ended = record.sent + *lasted;
    return std::nullopt;
}

Complaint readExchange(std::string_view line, bus::ExchangeRecord& record) {
    std::array<std::string_view, kFields> fields;
    std::size_t count = 0;
    for (std::size_t from = 0; from <= line.size(); ++count) {
        const std::size_t space = std::min(line.find(' ', from), line.size());
        if (count < kFields)
            fields[count] = line.substr(from, space - from);
        from = space + 1;
    }
    if (count != kFields)
        return "an exchange has " + std::to_string(kFields) + " fields, this line has " +
               std::to_string(count);
    if (auto wrong = readTimes(fields[0], fields[1], record))
        return wrong;
    const auto purpose = wordOf<bus::Purpose>(words::kPurposes, fields[2]);
    if (!purpose)
        return "the purpose is not known";
    record.purpose = *purpose;
    if (auto wrong = readModule(fields[3], record))
        return wrong;
    const auto baud = number<std::uint32_t>(fields[4]);
    if (!baud)
        return "the rate is not a number";
    record.baud = *baud;
    if (auto wrong = readLayout(fields[5], record))
        return wrong;
    if (auto wrong = readVerdict(fields[6], record))
        return wrong;
    if (auto wrong = readBytes(fields[7], '>', "command", record.command))
        return wrong;
    return readBytes(fields[8], '<', "reply", record.reply);
}

/// Returns one line after the other, and counts them.
class Reader {
public:
    explicit Reader(std::string_view text) : m_rest(text) {}

    [[nodiscard]] bool done() const { return m_rest.empty(); }
    /// Reads the next line, without its line feed. Must not be called if done().
    Complaint next(std::string_view& line) {
        ++m_number;
        const std::size_t end = m_rest.find('\n');
        if (end == std::string_view::npos)
            return "the file ends within this line";
        if (end > kMaxPacketLine)
            return "the line is longer than " + std::to_string(kMaxPacketLine) + " bytes";
        line = m_rest.substr(0, end);
        m_rest.remove_prefix(end + 1);
        return std::nullopt;
    }
    /// Reads a header line "# name value".
    Complaint header(std::string_view name, std::string& value) {
        std::string_view line;
        if (auto wrong = next(line))
            return wrong;
        const std::string prefix = "# " + std::string(name) + ' ';
        if (line.substr(0, prefix.size()) != prefix || line.size() > prefix.size() + kMaxHeaderText)
            return "\"" + prefix + "…\" is missing";
        value = line.substr(prefix.size());
        return std::nullopt;
    }
    Complaint exactly(std::string_view wanted) {
        std::string_view line;
        if (auto wrong = next(line))
            return wrong;
        if (line != wanted)
            return "\"" + std::string(wanted) + "\" is missing";
        return std::nullopt;
    }
    [[nodiscard]] std::string sentence(const std::string& complaint) const {
        return "Line " + std::to_string(m_number) + ": " + complaint + '.';
    }

private:
    std::string_view m_rest;
    std::size_t m_number = 0;
};

Complaint readHeader(Reader& reader, PacketFile& file) {
    std::string simulated;
    std::string dropped;
    if (auto wrong = reader.exactly(kMagic))
        return "this is not a packet log of this version";
    if (auto wrong = reader.header("program", file.session.program))
        return wrong;
    if (auto wrong = reader.header("started", file.session.startedAt))
        return wrong;
    if (auto wrong = reader.header("port", file.session.port))
        return wrong;
    if (auto wrong = reader.header("simulated", simulated))
        return wrong;
    if (simulated != "yes" && simulated != "no")
        return "simulated is neither yes nor no";
    file.session.simulated = simulated == "yes";
    if (auto wrong = reader.header("dropped", dropped))
        return wrong;
    const auto count = number<std::uint64_t>(dropped);
    if (!count)
        return "dropped is not a number";
    file.dropped = *count;
    if (auto wrong = reader.exactly(kColumns))
        return wrong;
    return reader.exactly("#");
}

Complaint readEntry(Reader& reader, PacketFile& file, bool& gap) {
    std::string_view line;
    if (auto wrong = reader.next(line))
        return wrong;
    if (line == kGap) {
        if (gap || file.entries.empty())
            return "a gap stands between two exchanges";
        gap = true;
        return std::nullopt;
    }
    PacketEntry entry;
    if (auto wrong = readExchange(line, entry.record))
        return wrong;
    entry.record.number = file.entries.size() + 1;
    entry.afterGap = std::exchange(gap, false);
    file.entries.push_back(std::move(entry));
    return std::nullopt;
}

}  // namespace

tl::expected<PacketFile, std::string> parsePacketFile(std::string_view text) {
    if (text.size() > kMaxPacketFile)
        return tl::unexpected("The file is longer than " + std::to_string(kMaxPacketFile >> 20U) + " MiB.");
    if (text.empty())
        return tl::unexpected(std::string("The file is empty."));
    PacketFile file;
    Reader reader(text);
    if (const auto wrong = readHeader(reader, file))
        return tl::unexpected(reader.sentence(*wrong));
    bool gap = false;
    while (!reader.done())
        if (const auto wrong = readEntry(reader, file, gap))
            return tl::unexpected(reader.sentence(*wrong));
    if (gap)
        return tl::unexpected(reader.sentence("a gap stands between two exchanges"));
    return file;
}

}  // namespace nmc
