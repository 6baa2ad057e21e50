// SPDX-License-Identifier: MIT
#include "model/machinefile/jsontree.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/text.h"

namespace nmc {

namespace {

using Kind = FileProblem::Kind;
constexpr int kOutOfNumbers = 406;  // an exception ID of nlohmann

/// The parser's progress in the text.
struct Progress {
    int line = 1;  ///< of the next character
    /// Line of the last non-blank character: the end of a number is detected only by what follows it.
    int lastLine = 1;
    bool ended = false;  ///< the parser reached the end of the text

    void passed(char c) {
        if (c == '\n')
            ++line;
        else if (c != ' ' && c != '\t' && c != '\r')
            lastLine = line;
    }
};

/// Feeds characters to the parser and records its progress.
class Cursor {
public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    Cursor(const char* at, Progress& progress) : m_at(at), m_progress(&progress) {}
    reference operator*() const { return *m_at; }
    Cursor& operator++() {
        m_progress->passed(*m_at++);
        return *this;
    }
    Cursor operator++(int) {
        Cursor before = *this;
        ++*this;
        return before;
    }
    friend bool operator==(const Cursor& a, const Cursor& b) {
        if (a.m_at == b.m_at)
            a.m_progress->ended = true;
        return a.m_at == b.m_at;
    }

private:
    const char* m_at;
    Progress* m_progress;
};

/// The letters around a position where the parser failed.
std::string wordAt(std::string_view text, std::size_t place) {
    const auto letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
    std::size_t begin = std::min(place, text.size());
    while (begin > 0 && letter(text[begin - 1]))
        --begin;
    std::size_t end = begin;
    while (end < text.size() && letter(text[end]) && end - begin < 10)
        ++end;
    return std::string(text.substr(begin, end - begin));
}

bool isNoNumber(std::string_view text) {
    const std::string word = lowered(text);
    return word == "nan" || word == "inf" || word == "infinity";
}

/// Builds the tree from the parser's events.
class TreeBuilder {
public:
    using Json = nlohmann::json;
    TreeBuilder(std::string_view text, const Progress& progress) : m_text(text), m_progress(progress) {}

    // Required by nlohmann's SAX interface; returning false ends the parsing.
    bool null() { return add({.line = line()}); }
    bool boolean(bool flag) { return add({.kind = JsonValue::Kind::Flag, .line = line(), .flag = flag}); }
    bool number_integer(Json::number_integer_t number) { return addNumber(static_cast<double>(number)); }
    bool number_unsigned(Json::number_unsigned_t number) { return addNumber(static_cast<double>(number)); }
    bool number_float(Json::number_float_t number, const std::string& /*digits*/) {
        return addNumber(number);
    }
    bool string(std::string& text) {
        return add({.kind = JsonValue::Kind::Text, .line = line(), .text = std::move(text)});
    }
    static bool binary(Json::binary_t& /*bytes*/) { return false; }
    bool start_object(std::size_t /*elements*/) { return open(JsonValue::Kind::Object); }
    bool start_array(std::size_t /*elements*/) { return open(JsonValue::Kind::List); }
    bool end_object() { return close(); }
    bool end_array() { return close(); }
    bool key(std::string& key) {
        JsonValue& object = *m_open.back();
        if (object.find(key) != nullptr)
            return refuse({.kind = Kind::DuplicateKey, .field = key});
        object.keys.push_back(key);
        return true;
    }
    bool parse_error(std::size_t position, const std::string& /*token*/, const Json::exception& error) {
        if (error.id == kOutOfNumbers)
            return refuse({.kind = Kind::NumberTooBig});
        const std::string word = wordAt(m_text, position > 0 ? position - 1 : 0);
        if (isNoNumber(word))
            return refuse({.kind = Kind::NotANumber, .found = word});
        return refuse({.kind = m_progress.ended ? Kind::Truncated : Kind::NotJson});
    }

    [[nodiscard]] JsonValue& root() { return m_root; }
    [[nodiscard]] const std::optional<FileProblem>& problem() const { return m_problem; }

private:
    [[nodiscard]] int line() const { return m_progress.lastLine; }
    bool refuse(FileProblem problem) {
        problem.line = line();
        m_problem = std::move(problem);
        return false;
    }
    bool addNumber(double number) {
        return add({.kind = JsonValue::Kind::Number, .line = line(), .number = number});
    }
    bool add(JsonValue value) {
        if (++m_values > kMaxJsonValues)
            return refuse({.kind = Kind::TooManyValues, .max = kMaxJsonValues});
        (m_open.empty() ? m_root : m_open.back()->items.emplace_back()) = std::move(value);
        return true;
    }
    bool open(JsonValue::Kind kind) {
        if (m_open.size() >= kMaxJsonDepth)
            return refuse({.kind = Kind::TooDeep, .max = kMaxJsonDepth});
        if (!add({.kind = kind, .line = line()}))
            return false;
        // It stays in place until it is closed.
        m_open.push_back(m_open.empty() ? &m_root : &m_open.back()->items.back());
        return true;
    }
    bool close() {
        m_open.pop_back();
        return true;
    }

    std::string_view m_text;
    const Progress& m_progress;
    JsonValue m_root;
    std::vector<JsonValue*> m_open;
    std::optional<FileProblem> m_problem;
    int m_values = 0;
};

/// The valid range of the first byte after a lead byte, and how many bytes follow (Unicode, table 3-7).
struct Utf8Sequence {
    std::size_t following;
    unsigned char low = 0x80;  ///< of the first of them
    unsigned char high = 0xBF;
};

std::optional<Utf8Sequence> sequenceOf(unsigned char lead) {
    if (lead < 0x80)
        return Utf8Sequence{0};
    if (lead >= 0xC2 && lead <= 0xDF)
        return Utf8Sequence{1};
    if (lead >= 0xE0 && lead <= 0xEF)
        return Utf8Sequence{2, static_cast<unsigned char>(lead == 0xE0 ? 0xA0 : 0x80),
                            static_cast<unsigned char>(lead == 0xED ? 0x9F : 0xBF)};
    if (lead >= 0xF0 && lead <= 0xF4)
        return Utf8Sequence{3, static_cast<unsigned char>(lead == 0xF0 ? 0x90 : 0x80),
                            static_cast<unsigned char>(lead == 0xF4 ? 0x8F : 0xBF)};
    return std::nullopt;
}

/// Returns the first byte that is not UTF-8. A sequence cut by the end of the text is not wrong, only short.
std::optional<std::size_t> firstWrongByte(std::string_view text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto sequence = sequenceOf(static_cast<unsigned char>(text[i]));
        if (!sequence)
            return i;
        const std::size_t start = i;
        for (std::size_t k = 1; k <= sequence->following && start + k < text.size(); ++k) {
            const auto byte = static_cast<unsigned char>(text[start + k]);
            if (byte < (k == 1 ? sequence->low : 0x80) || byte > (k == 1 ? sequence->high : 0xBF))
                return start + k;
            i = start + k;
        }
    }
    return std::nullopt;
}

int lineOf(std::string_view text, std::size_t place) {
    return 1 + static_cast<int>(
                   std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(place), '\n'));
}

}  // namespace

const JsonValue* JsonValue::find(std::string_view key) const {
    const auto found = std::ranges::find(keys, key);
    return found != keys.end() ? &items[static_cast<std::size_t>(found - keys.begin())] : nullptr;
}

tl::expected<JsonValue, FileProblem> parseJson(std::string_view text) {
    if (text.find_first_not_of(" \t\r\n") == std::string_view::npos)
        return tl::unexpected(FileProblem{.kind = Kind::Empty});
    if (const auto wrong = firstWrongByte(text))
        return tl::unexpected(FileProblem{.kind = Kind::NotUtf8, .line = lineOf(text, *wrong)});
    Progress progress;
    TreeBuilder builder(text, progress);
    const bool whole = nlohmann::json::sax_parse(Cursor(text.data(), progress),
                                                 Cursor(text.data() + text.size(), progress), &builder);
    if (!whole)
        return tl::unexpected(builder.problem().value_or(FileProblem{.kind = Kind::NotJson}));
    return std::move(builder.root());
}

}  // namespace nmc
