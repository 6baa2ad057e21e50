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

/// Why a recording was not read, or not to its end. Data only.
struct RecordingProblem {
    enum class Kind : std::uint8_t {
        Empty,
        OtherFormat,    ///< it does not say that it is a recording
        OtherForm,      ///< one column per signal (model/recording/widerecording.h)
        NewerVersion,   ///< `found` is its version, `max` the newest this program knows
        NoColumns,      ///< it ends above the line that names the columns
        MissingColumn,  ///< `field`
        LineTooLong,    ///< longer than `max` bytes
        Truncated,      ///< it ends within the line, which is not read
        TooFewCells,    ///< `found` of them; `max` are wanted
        EmptyCell,      ///< of `field`, which every row must have
        NotANumber,     ///< `field` is `found`
        OutOfRange,     ///< `field` is `found`; `min` to `max`
        TimeGoesBack,   ///< of module `found`
    };
    Kind kind = Kind::Empty;
    std::uint64_t line = 1;  ///< from 1
    std::string field{};     ///< a column or a key, as it stands in the file
    std::string found{};     ///< what stands there; long texts are cut, what cannot be printed is '?'
    double min = 0.0;
    double max = 0.0;

    bool operator==(const RecordingProblem&) const = default;
};

/// Reads a recording piece by piece and hands on each row at once, so that a file of any size needs no
/// memory. Everything above the first problem is good; nothing below it is read. Columns are found by name,
/// in any order: what is not there is not known, and what this program does not know is passed over. A
/// spreadsheet may have saved the file again, with semicolons or tabs between the cells and decimal commas.
/// Pure; throws nothing of its own.
class RecordingReader {
public:
    static constexpr std::size_t kMaxLine = 20'000;  ///< bytes

    /// Called from within feed(), in the order of the file.
    struct Takers {
        std::function<void(ModuleIndex, const ScopeSample&)> sample;
        std::function<void(const GainsChange&)> gains{};
    };
    explicit RecordingReader(Takers takers) : m_takers(std::move(takers)) {}

    /// The next piece, cut anywhere. False: there is a problem, and further pieces are passed over.
    bool feed(std::string_view chunk);
    /// No more pieces will come. Nothing: all was read.
    const std::optional<RecordingProblem>& finish();

    /// Complete when the first sample is handed on.
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
    std::string m_begun;    ///< a line whose end has not come yet
    char m_padding = '\0';  ///< what a spreadsheet has put behind comments
    char m_separator = '\0';
    std::size_t m_columns = 0;
    std::array<std::optional<std::size_t>, kRecordingColumns.size()> m_placeOf{};
    std::vector<std::string_view> m_cells;  ///< of the line being read
    std::array<std::optional<TimePoint>, 256> m_lastTime{};
};

}  // namespace nmc
