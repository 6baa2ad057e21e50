// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/recording/recording.h"
#include "model/recording/recordingcells.h"

namespace nmc {

/// Why a recording could not be read, or not to its end. Data only.
struct RecordingProblem {
    enum class Kind : std::uint8_t {
        Empty,
        OtherFormat,    ///< the file does not identify itself as a recording
        OtherForm,      ///< one column per signal (model/recording/widerecording.h)
        NewerVersion,   ///< `found` is its version, `max` the newest this program knows
        NoColumns,      ///< it ends before the line with the column names
        MissingColumn,  ///< `field` is missing
        LineTooLong,    ///< longer than `max` bytes
        Truncated,      ///< it ends within this line, which is not read
        TooFewCells,    ///< `found` cells; `max` are required
        EmptyCell,      ///< the cell of `field`, which every row must have
        NotANumber,     ///< `field` is `found`
        OutOfRange,     ///< `field` is `found`; `min` to `max`
        TimeGoesBack,   ///< in the rows of module `found`
    };
    Kind kind = Kind::Empty;
    std::uint64_t line = 1;  ///< from 1
    std::string field{};     ///< a column or a key, as written in the file
    std::string found{};     ///< the text in the file; long texts are cut, unprintable characters are '?'
    double min = 0.0;
    double max = 0.0;

    bool operator==(const RecordingProblem&) const = default;
};

/// Reads a recording in pieces and passes on each row at once, so that memory does not grow with the file
/// size. Everything above the first problem is valid; nothing below it is read. Columns are found by name, in
/// any order: missing columns are unknown, and columns that this program does not know are ignored. A
/// spreadsheet may have saved the file again, with semicolons or tabs between the cells and decimal commas.
/// Pure; throws no exceptions of its own.
class RecordingReader {
public:
    static constexpr std::size_t kMaxLine = 20'000;  ///< bytes

    /// Called from within feed(), in file order.
    struct Takers {
        std::function<void(ModuleIndex, const ScopeSample&)> sample;
        std::function<void(const GainsChange&)> gains{};
    };
    explicit RecordingReader(Takers takers) : m_takers(std::move(takers)) {}

    /// Reads the next piece, cut at any point. Returns false when there is a problem; further pieces are then
    /// ignored.
    bool feed(std::string_view chunk);
    /// Called after the last piece. Returns nothing if everything was read.
    const std::optional<RecordingProblem>& finish();

    /// Complete when the first sample is passed on.
    [[nodiscard]] const RecordingHeader& header() const { return m_header; }
    [[nodiscard]] std::uint64_t samples() const { return m_samples; }

private:
    using Kind = RecordingProblem::Kind;

    void takeLine(std::string_view line);
    void takeFirstLine(std::string_view line);
    void takeComment(std::string_view line);
    void takeColumns(std::string_view line);
    void takeRow(std::string_view line);

    template <typename Number>
    void wholeCell(RecordingColumn column, Number& number, cells::Bounds bounds);
    void realCell(RecordingColumn column, float& number);
    void pinCells(ScopeSample& sample);
    void timeCell(TimePoint& time);
    [[nodiscard]] std::string_view cell(RecordingColumn column) const;
    void refuse(RecordingProblem problem);

    Takers m_takers;
    RecordingHeader m_header;
    std::optional<RecordingProblem> m_problem;
    std::uint64_t m_line = 0;
    std::uint64_t m_samples = 0;
    std::string m_begun;    ///< an unfinished line
    char m_padding = '\0';  ///< the characters that a spreadsheet has added after comments
    char m_separator = '\0';
    std::size_t m_columns = 0;
    std::array<std::optional<std::size_t>, kRecordingColumns.size()> m_placeOf{};
    std::vector<std::string_view> m_cells;  ///< cells of the line being read
    std::array<std::optional<TimePoint>, 256> m_lastTime{};
};

}  // namespace nmc
