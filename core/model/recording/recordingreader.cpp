// SPDX-License-Identifier: MIT
#include "model/recording/recordingreader.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "model/recording/recordingcomments.h"
#include "model/recording/widerecording.h"

namespace nmc {

namespace {

constexpr std::string_view kSeparators = ",;\t";
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr std::string_view kComment = "# ";
/// The columns that every row must have.
constexpr std::array kRequired{RecordingColumn::Module, RecordingColumn::Time, RecordingColumn::Position};
constexpr cells::Bounds kPositions{std::numeric_limits<std::int32_t>::min(),
                                   std::numeric_limits<std::int32_t>::max()};
constexpr auto kMaxFloat = static_cast<double>(std::numeric_limits<float>::max());
constexpr cells::Bounds kFloats{-kMaxFloat, kMaxFloat};

std::string_view nameOf(RecordingColumn column) {
    return kRecordingColumns[static_cast<std::size_t>(column)];
}

}  // namespace

// ---- lines ----

bool RecordingReader::feed(std::string_view chunk) {
    while (!m_problem && !chunk.empty()) {
        const std::size_t end = chunk.find('\n');
        const std::string_view piece = chunk.substr(0, end);
        if (m_begun.size() + piece.size() > kMaxLine) {
            ++m_line;
            refuse({.kind = m_line == 1 ? Kind::OtherFormat : Kind::LineTooLong,
                    .max = static_cast<double>(kMaxLine)});
        } else if (end == std::string_view::npos) {
            m_begun += piece;
        } else if (m_begun.empty()) {
            takeLine(piece);
        } else {
            m_begun += piece;
            takeLine(m_begun);
            m_begun.clear();
        }
        chunk.remove_prefix(std::min(piece.size() + 1, chunk.size()));
    }
    return !m_problem;
}

const std::optional<RecordingProblem>& RecordingReader::finish() {
    if (m_problem)
        return m_problem;
    const std::string rest = std::exchange(m_begun, {});
    if (m_line == 0 && rest.empty()) {
        refuse({.kind = Kind::Empty});
    } else if (m_line == 0) {
        takeLine(rest);
        refuse({.kind = Kind::Truncated});
    } else if (!rest.empty()) {
        // It is impossible to know whether digits are missing at the end of the last line.
        ++m_line;
        refuse({.kind = Kind::Truncated});
    } else if (m_columns == 0) {
        refuse({.kind = Kind::NoColumns});
    }
    return m_problem;
}

void RecordingReader::takeLine(std::string_view line) {
    ++m_line;
    if (line.ends_with('\r'))
        line.remove_suffix(1);
    if (m_line == 1)
        takeFirstLine(line);
    else if (line.starts_with('#') || line.starts_with("\"#"))
        takeComment(line);
    else if (line.find_first_not_of(kSeparators) == std::string_view::npos)
        return;
    else if (m_columns == 0)
        takeColumns(line);
    else
        takeRow(line);
}

void RecordingReader::refuse(RecordingProblem problem) {
    if (m_problem)
        return;
    problem.line = std::max<std::uint64_t>(m_line, 1);
    m_problem = std::move(problem);
}

// ---- comments ----

void RecordingReader::takeFirstLine(std::string_view line) {
    if (line.starts_with(kByteOrderMark))
        line.remove_prefix(kByteOrderMark.size());
    const std::string text = cells::unquoted(line);
    if (!text.starts_with(kRecordingMagic))
        return refuse({.kind = text.starts_with(kWideTime) ? Kind::OtherForm : Kind::OtherFormat});
    std::string_view version = std::string_view(text).substr(kRecordingMagic.size());
    if (const std::size_t end = version.find_first_of(kSeparators); end != std::string_view::npos) {
        m_padding = version[end];
        version = version.substr(0, end);
    }
    const auto number = cells::whole(version, {1, std::numeric_limits<int>::max()});
    if (!number)
        return refuse({.kind = Kind::OtherFormat});
    if (*number > kRecordingVersion)
        refuse({.kind = Kind::NewerVersion, .found = comments::shown(version), .max = kRecordingVersion});
}

void RecordingReader::takeComment(std::string_view line) {
    if (m_padding != '\0')
        line = line.substr(0, line.find_last_not_of(m_padding) + 1);
    const std::string unquoted = cells::unquoted(line);
    std::string_view text = unquoted;
    if (!text.starts_with(kComment))
        return;
    text.remove_prefix(kComment.size());
    if (const auto inForce = comments::gainsOf(text); inForce && m_takers.gains)
        m_takers.gains(*inForce);
    else if (m_columns == 0)
        if (auto problem = comments::takeHeadEntry(text, m_header))
            refuse(std::move(*problem));
}

// ---- rows ----

void RecordingReader::takeColumns(std::string_view line) {
    const std::size_t separator = line.find_first_of(kSeparators);
    m_separator = separator == std::string_view::npos ? ',' : line[separator];
    cells::split(line, m_separator, m_cells);
    for (std::size_t i = 0; i < kRecordingColumns.size(); ++i) {
        const auto place = std::ranges::find(m_cells, kRecordingColumns[i]);
        if (place != m_cells.end())
            m_placeOf[i] = static_cast<std::size_t>(place - m_cells.begin());
    }
    // Empty names at the end come from a spreadsheet, so such cells may be missing.
    while (!m_cells.empty() && m_cells.back().empty())
        m_cells.pop_back();
    m_columns = m_cells.size();
    for (const RecordingColumn column : kRequired)
        if (!m_placeOf[static_cast<std::size_t>(column)])
            return refuse({.kind = Kind::MissingColumn, .field = std::string(nameOf(column))});
}

void RecordingReader::takeRow(std::string_view line) {
    cells::split(line, m_separator, m_cells);
    if (m_cells.size() < m_columns)
        return refuse({.kind = Kind::TooFewCells,
                       .found = std::to_string(m_cells.size()),
                       .max = static_cast<double>(m_columns)});
    for (const RecordingColumn column : kRequired)
        if (cell(column).empty())
            return refuse({.kind = Kind::EmptyCell, .field = std::string(nameOf(column))});
    int number = 0;
    int gap = 0;
    ScopeSample sample;
    using Column = RecordingColumn;
    wholeCell(Column::Module, number, comments::kModules);
    timeCell(sample.time);
    wholeCell(Column::Position, sample.position, kPositions);
    if (cell(Column::Counted).empty()) {
        realCell(Column::Velocity, sample.velocity);
        realCell(Column::Error, sample.error);
        realCell(Column::ErrorLow, sample.errorLow);
        realCell(Column::ErrorHigh, sample.errorHigh);
    } else {
        pinCells(sample);
    }
    wholeCell(Column::Analog, sample.analog, comments::kBytes);
    wholeCell(Column::Status, sample.status, comments::kBytes);
    wholeCell(Column::Aux, sample.aux, comments::kBytes);
    wholeCell(Column::Gap, gap, {0, 1});
    if (m_problem)
        return;
    auto& last = m_lastTime[static_cast<std::size_t>(number)];
    if (last && sample.time < *last)
        return refuse({.kind = Kind::TimeGoesBack,
                       .field = std::string(nameOf(Column::Time)),
                       .found = std::to_string(number)});
    last = sample.time;
    sample.gapBefore = gap == 1;
    ++m_samples;
    m_takers.sample(ModuleIndex(static_cast<std::uint8_t>(number - 1)), sample);
}

/// A row of a PIC-I/O stores its values in the members of a motor's sample (scopesample.h).
void RecordingReader::pinCells(ScopeSample& sample) {
    const auto byteCell = [this](RecordingColumn column, float& number) {
        int byte = -1;
        wholeCell(column, byte, comments::kBytes);
        if (byte >= 0)
            number = static_cast<float>(byte);
    };
    int counted = 0;
    wholeCell(RecordingColumn::Counted, counted, {0, 1});
    byteCell(RecordingColumn::Analog2, sample.error);
    byteCell(RecordingColumn::Analog3, sample.velocity);
    sample.setCounter(static_cast<std::uint32_t>(sample.position));
    sample.io = true;
    sample.counted = counted == 1;
}

std::string_view RecordingReader::cell(RecordingColumn column) const {
    const auto place = m_placeOf[static_cast<std::size_t>(column)];
    return place ? m_cells[*place] : std::string_view{};
}

template <typename Number>
void RecordingReader::wholeCell(RecordingColumn column, Number& number, cells::Bounds bounds) {
    const std::string_view text = cell(column);
    if (text.empty())
        return;
    if (const auto value = cells::whole(text, bounds))
        number = static_cast<Number>(*value);
    else
        refuse(comments::problemOf(value.error(), nameOf(column), text, bounds));
}

void RecordingReader::realCell(RecordingColumn column, float& number) {
    const std::string_view text = cell(column);
    if (text.empty())
        return;
    if (const auto value = cells::real(text))
        number = *value;
    else
        refuse(comments::problemOf(value.error(), nameOf(column), text, kFloats));
}

void RecordingReader::timeCell(TimePoint& time) {
    const std::string_view text = cell(RecordingColumn::Time);
    if (const auto value = cells::time(text))
        time = TimePoint(*value);
    else
        refuse(comments::problemOf(value.error(), nameOf(RecordingColumn::Time), text, cells::kTimes));
}

}  // namespace nmc
