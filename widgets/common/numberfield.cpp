// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/numberfield.h"

#include <QKeyEvent>
#include <QLocale>
#include <QPainter>
#include <QRegularExpression>
#include <QSignalBlocker>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <utility>

#include "widgets/common/glyphs.h"
#include "widgets/common/look.h"
#include "widgets/common/words.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
/// Longer than any number here; a huge paste is cut to this length, which is still out of range.
constexpr int kMaxLength = 32;

/// True for a space of any width between groups of three digits, as this program and others write them. No
/// group has more digits, so "1000 200", two numbers, is not read as one.
bool separatesGroups(const QString& text, qsizetype at) {
    const auto isDigit = [&text](qsizetype i) {
        return i >= 0 && i < text.size() && text.at(i) >= u'0' && text.at(i) <= u'9';
    };
    const bool tooLong = isDigit(at - 2) && isDigit(at - 3) && isDigit(at - 4);
    return text.at(at).category() == QChar::Separator_Space && isDigit(at - 1) && !tooLong &&
           isDigit(at + 1) && isDigit(at + 2) && isDigit(at + 3) && !isDigit(at + 4);
}

/// The locale's decimal mark if it is one of the two that are read, otherwise the point.
QChar decimalMark() {
    return QLocale().decimalPoint() == u","_s ? u',' : u'.';
}
}  // namespace

NumberField::NumberField(int decimals, QWidget* parent) : QLineEdit(parent), m_decimals(decimals) {
    setMaxLength(kMaxLength);
    setAlignment(Qt::AlignRight);
    setFocusPolicy(Qt::StrongFocus);
    setFont(look::tabular(font()));
    setInputMethodHints(Qt::ImhFormattedNumbersOnly);
    connect(this, &QLineEdit::textChanged, this, &NumberField::judge);
    // QLineEdit emits textEdited() before textChanged(); receivers of edited() must find the new value
    // checked.
    connect(this, &QLineEdit::textEdited, this, [this] {
        judge();
        emit edited();
    });
    judge();
}

void NumberField::setRange(double min, double max) {
    if (min == m_min && max == m_max)
        return;
    m_min = min;
    m_max = max;
    judge();
}

void NumberField::setRangeReason(const QString& reason) {
    if (std::exchange(m_rangeReason, reason) != reason)
        judge();
}

void NumberField::setDecimals(int decimals) {
    m_decimals = decimals;
    judge();
}

void NumberField::setDigits(int digits) {
    m_digits = digits;
    updateGeometry();
}

void NumberField::setWords(const QString& quantity, const QString& unit) {
    if (m_quantity == quantity && m_unit == unit)
        return;
    m_quantity = quantity;
    m_unit = unit;
    judge();
}

void NumberField::setMeaning(const QString& meaning) {
    if (std::exchange(m_meaning, meaning) != meaning)
        judge();
}

void NumberField::setUnavailable(const QString& why) {
    if (why == m_unavailable)
        return;
    m_unavailable = why;
    setReadOnly(!why.isEmpty());
    setPlaceholderText(why.isEmpty() ? QString() : u"–"_s);
    judge();
}

void NumberField::setPossible(const QString& reason, const QString& meaning) {
    setEnabled(reason.isEmpty());
    setMeaning(reason.isEmpty() ? meaning : reason);
}

std::optional<double> NumberField::parse(const QString& text, bool wholeOnly, Problem* problem) {
    const QString trimmed = text.trimmed();
    *problem = trimmed.isEmpty() ? Problem::Empty : Problem::NotANumber;
    std::string plain;
    int marks = 0;
    int digits = 0;
    for (qsizetype i = 0; i < trimmed.size(); ++i) {
        const char16_t c = trimmed.at(i).unicode();
        if (c >= u'0' && c <= u'9') {
            plain += static_cast<char>('0' + (c - u'0'));
            ++digits;
        } else if (c == u'.' || c == u',') {
            plain += '.';
            ++marks;
        } else if (i == 0 && (c == u'-' || c == u'\u2212')) {
            plain += '-';
        } else if ((i != 0 || c != u'+') && !separatesGroups(trimmed, i)) {
            return std::nullopt;
        }
    }
    if (wholeOnly && marks > 0) {
        *problem = Problem::NotWhole;
        return std::nullopt;
    }
    if (marks > 1) {
        *problem = Problem::TwoMarks;
        return std::nullopt;
    }
    if (digits == 0)
        return std::nullopt;
    double value = 0;
    const auto [end, error] =
        std::from_chars(plain.data(), plain.data() + plain.size(), value, std::chars_format::fixed);
    if (error != std::errc() || end != plain.data() + plain.size())
        return std::nullopt;
    *problem = Problem::None;
    return value;
}

QString NumberField::format(double value, int decimals) {
    // Digits as the parser reads them; only the decimal mark is taken from the locale.
    QString text = QLocale::c().toString(value, 'f', decimals).remove(u',');
    if (decimals > 0) {
        while (text.endsWith(u'0'))
            text.chop(1);
        if (text.endsWith(u'.'))
            text.chop(1);
        text.replace(u'.', decimalMark());
    }
    return text;
}

std::optional<double> NumberField::value() const {
    if (m_problem != Problem::None)
        return std::nullopt;
    Problem ignored = Problem::None;
    return std::max(m_min, std::min(m_max, *parse(text(), m_decimals == 0, &ignored)));
}

QString NumberField::textOf(double value) const {
    constexpr int kMaxDecimals = 12;
    int decimals = m_decimals;
    while (m_decimals > 0 && decimals < kMaxDecimals && value != 0.0 &&
           std::abs(value) * std::pow(10.0, decimals) < 10.0)
        ++decimals;
    return format(value, decimals);
}

bool NumberField::isAllowed(double number) const {
    const auto writtenAs = [this, number](double limit) {
        Problem ignored = Problem::None;
        return parse(textOf(limit), m_decimals == 0, &ignored) == number;
    };
    return (number >= m_min && number <= m_max) || writtenAs(m_min) || writtenAs(m_max);
}

QString NumberField::problemText() const {
    const QString quantity = m_quantity.isEmpty() ? accessibleName() : m_quantity;
    const QString unit = m_unit.isEmpty() ? QString() : u" "_s + m_unit;
    const auto range = [&] {
        return tr("%1 must be %2 to %3%4.").arg(quantity, textOf(m_min), textOf(m_max), unit);
    };
    switch (m_problem) {
        case Problem::None:
            return {};
        case Problem::Unavailable:
            return m_unavailable;
        case Problem::Empty:
            return tr("Enter a value for %1.").arg(quantity) + u" "_s + range();
        case Problem::NotANumber:
            return tr("%1 must be a number.").arg(quantity) + u" "_s + range();
        case Problem::TwoMarks:
            return tr("%1 has two decimal marks. Both , and . count as decimal marks.").arg(quantity);
        case Problem::NotWhole:
            return tr("%1 must be a whole number without , or . in it.").arg(quantity) + u" "_s + range();
        case Problem::Ambiguous:
            return tr("%1: %2 can be read in two ways. Press Enter in the field for %3, or type %4.")
                .arg(quantity, text().trimmed(), asFraction(), asFraction().remove(decimalMark()).chopped(1));
        case Problem::OutOfRange:
            return m_rangeReason.isEmpty() ? range() : range() + u' ' + m_rangeReason;
    }
    return {};
}

void NumberField::showValue(double value) {
    showText(textOf(value));
}

void NumberField::showNothing() {
    showText({});
}

void NumberField::showText(const QString& text) {
    if (this->text() == text)
        return;
    const QSignalBlocker blocker(this);
    setText(text);
    judge();
}

void NumberField::judge() {
    Problem problem = Problem::None;
    const std::optional<double> number = parse(text(), m_decimals == 0, &problem);
    if (number.has_value() && !isAllowed(*number))
        problem = Problem::OutOfRange;
    if (number.has_value() && m_decimals > 0 && isAmbiguous())
        problem = Problem::Ambiguous;
    if (!m_unavailable.isEmpty())
        problem = Problem::Unavailable;
    if (std::exchange(m_problem, problem) != problem)
        update();  // the mark
    const QString trouble = problemText();
    const bool show = m_problem != Problem::None && m_problem != Problem::Empty;
    setToolTip(show && !m_meaning.isEmpty() ? trouble + u"\n\n"_s + m_meaning : show ? trouble : m_meaning);
    setAccessibleDescription(show ? trouble : m_meaning);
    const int mark = show && m_problem != Problem::Unavailable ? fontMetrics().height() : 0;
    if (textMargins().left() != mark)
        setTextMargins(mark, 0, 0, 0);
}

bool NumberField::isAmbiguous() const {
    static const QRegularExpression groups(u"^[-\u2212+]?[1-9][0-9]{0,2}[.,][0-9]{3}$"_s);
    return isModified() && groups.match(text().trimmed()).hasMatch();
}

QString NumberField::asFraction() const {
    return text().trimmed().replace(u'.', decimalMark()).replace(u',', decimalMark()) + u'0';
}

void NumberField::moveBy(int steps) {
    const std::optional<double> now = value();
    if (!now.has_value() || isReadOnly() || steps == 0)
        return;
    const double next = std::round(*now / m_step + steps) * m_step;
    if (next < m_min || next > m_max)
        return;
    showValue(next);
    emit edited();
}

bool NumberField::event(QEvent* event) {
    // Undo is handled by the owner of the values, not character by character in a field.
    if (event->type() == QEvent::ShortcutOverride) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
            event->ignore();
            return true;
        }
    }
    return QLineEdit::event(event);
}

void NumberField::keyPressEvent(QKeyEvent* event) {
    const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (enter && m_problem == Problem::Ambiguous) {
        // Shows how the number is understood; the next Enter acts.
        showText(asFraction());
        setModified(true);
        emit edited();
        event->accept();
    } else if (event->key() == Qt::Key_Up || event->key() == Qt::Key_Down) {
        moveBy(event->key() == Qt::Key_Up ? 1 : -1);
        event->accept();
    } else if (event->key() == Qt::Key_PageUp || event->key() == Qt::Key_PageDown) {
        moveBy(event->key() == Qt::Key_PageUp ? 10 : -10);
        event->accept();
    } else {
        if (enter && m_problem != Problem::None)
            QToolTip::showText(mapToGlobal(rect().bottomLeft()), toolTip(), this);
        QLineEdit::keyPressEvent(event);
    }
}

void NumberField::wheelEvent(QWheelEvent* event) {
    m_wheelRest += event->angleDelta().y();
    const int steps = m_wheelRest / 120;
    m_wheelRest -= steps * 120;
    moveBy(steps);
    event->accept();
}

void NumberField::paintEvent(QPaintEvent* event) {
    QLineEdit::paintEvent(event);
    if (m_problem == Problem::None || m_problem == Problem::Unavailable || m_problem == Problem::Empty)
        return;
    QPainter painter(this);
    const int side = qRound(fontMetrics().ascent() * 0.95);
    paintSeverity(painter, QRectF(side * 0.5, (height() - side) / 2.0, side, side), Severity::Attention,
                  palette());
    QPen pen(look::severityFill(Severity::Attention, palette()), 2);
    pen.setStyle(Qt::DashLine);
    painter.setPen(pen);
    painter.drawRect(rect().adjusted(1, 1, -1, -1));
}

QSize NumberField::sizeHint() const {
    QSize hint = QLineEdit::sizeHint();
    hint.setWidth(fontMetrics().horizontalAdvance(u'0') * m_digits + fontMetrics().height());
    return hint;
}

}  // namespace nmc
