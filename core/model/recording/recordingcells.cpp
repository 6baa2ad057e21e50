// SPDX-License-Identifier: MIT
#include "model/recording/recordingcells.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "base/text.h"

namespace nmc::cells {

namespace {

constexpr std::string_view kAround = " \t\"";

/// A cell with a decimal point; longer cells are not numbers of this format.
class Plain {
public:
    explicit Plain(std::string_view cell) : m_size(cell.size()) {
        if (m_size <= m_text.size())
            std::replace_copy(cell.begin(), cell.end(), m_text.begin(), ',', '.');
    }
    template <typename Real>
    [[nodiscard]] std::from_chars_result read(Real& number) const {
        if (m_size > m_text.size())
            return {m_text.data(), std::errc::invalid_argument};
        const auto result = std::from_chars(m_text.data(), m_text.data() + m_size, number);
        if (result.ptr != m_text.data() + m_size)
            return {result.ptr, std::errc::invalid_argument};
        return result;
    }

private:
    std::array<char, 64> m_text{};
    std::size_t m_size;
};

tl::expected<double, Fault> finite(std::string_view cell) {
    double number = 0.0;
    const auto error = Plain(cell).read(number).ec;
    if (error == std::errc::result_out_of_range)
        return tl::unexpected(Fault::OutOfRange);
    if (error != std::errc{} || !std::isfinite(number))
        return tl::unexpected(Fault::NotANumber);
    return number;
}

constexpr bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

/// Returns nothing for a number that is not written with at most nine decimals.
std::optional<Duration> exactTime(std::string_view cell) {
    constexpr std::size_t kMaxDigits = 9;
    const bool negative = cell.starts_with('-');
    cell.remove_prefix(negative ? 1 : 0);
    const std::size_t mark = std::min(cell.find_first_of(".,"), cell.size());
    const std::string_view seconds = cell.substr(0, mark);
    const std::string_view fraction = cell.substr(std::min(mark + 1, cell.size()));
    if (seconds.empty() || seconds.size() > kMaxDigits || fraction.size() > kMaxDigits ||
        !std::ranges::all_of(seconds, isDigit) || !std::ranges::all_of(fraction, isDigit))
        return std::nullopt;
    std::int64_t ns = 0;
    for (const char digit : seconds)
        ns = ns * 10 + (digit - '0');
    for (std::size_t i = 0; i < kMaxDigits; ++i)
        ns = ns * 10 + (i < fraction.size() ? fraction[i] - '0' : 0);
    return Duration(negative ? -ns : ns);
}

}  // namespace

void split(std::string_view line, char separator, std::vector<std::string_view>& cells) {
    cells.clear();
    bool quoted = false;
    std::size_t from = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '"')
            quoted = !quoted;
        else if (line[i] == separator && !quoted) {
            cells.push_back(trimmed(line.substr(from, i - from), kAround));
            from = i + 1;
        }
    }
    cells.push_back(trimmed(line.substr(from), kAround));
}

std::string unquoted(std::string_view text) {
    if (!text.starts_with('"'))
        return std::string(text);
    std::string inside;
    for (std::size_t i = 1; i < text.size(); ++i) {
        if (text[i] == '"' && (i + 1 == text.size() || text[++i] != '"'))
            break;
        inside += text[i];
    }
    return inside;
}

tl::expected<double, Fault> real(std::string_view cell, Bounds bounds) {
    const auto number = finite(cell);
    const double amount = number && bounds.eitherSign ? std::abs(*number) : number.value_or(0);
    if (number && (amount < bounds.min || amount > bounds.max))
        return tl::unexpected(Fault::OutOfRange);
    return number;
}

tl::expected<std::int64_t, Fault> whole(std::string_view cell, Bounds bounds) {
    const auto number = finite(cell);
    if (!number)
        return tl::unexpected(number.error());
    if (*number != std::trunc(*number))
        return tl::unexpected(Fault::NotANumber);
    if (*number < bounds.min || *number > bounds.max)
        return tl::unexpected(Fault::OutOfRange);
    return static_cast<std::int64_t>(*number);
}

tl::expected<float, Fault> real(std::string_view cell) {
    float number = 0.0F;
    const auto error = Plain(cell).read(number).ec;
    if (error == std::errc{} && !std::isinf(number))
        return number;
    if (error != std::errc::result_out_of_range)
        return tl::unexpected(Fault::NotANumber);
    // A number too small for a float is read as zero; one too large is an error.
    if (const auto wide = finite(cell); wide && std::abs(*wide) < 1.0)
        return 0.0F;
    return tl::unexpected(Fault::OutOfRange);
}

tl::expected<Duration, Fault> time(std::string_view cell) {
    const auto seconds = real(cell, kTimes);
    if (!seconds)
        return tl::unexpected(seconds.error());
    return exactTime(cell).value_or(fromSeconds(*seconds));
}

}  // namespace nmc::cells
