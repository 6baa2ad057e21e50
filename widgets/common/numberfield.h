// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLineEdit>
#include <QString>
#include <optional>

namespace nmc {

/// A field for one number in one unit (interface.md, "Values"). Numbers are read in the same way in every
/// locale, and never by guessing: whole numbers have no decimal mark. In other numbers, both , and . are
/// decimal marks, two marks are rejected, and a number typed like groups of thousands, 1,234 or 1.234, has no
/// value until Enter has turned it into 1.2340. A number that is out of range stays as typed and has no
/// value; the field is marked and says the range. The wheel works only in a focused field.
class NumberField : public QLineEdit {
    Q_OBJECT

public:
    enum class Problem : std::uint8_t {
        None,
        Unavailable,
        Empty,
        NotANumber,
        TwoMarks,
        NotWhole,
        Ambiguous,
        OutOfRange
    };

    /// `decimals`: how many are shown; more may be typed. 0: whole numbers only.
    explicit NumberField(int decimals, QWidget* parent = nullptr);

    void setRange(double min, double max);
    /// Which setting determines the range, as a sentence; empty: the module does.
    void setRangeReason(const QString& reason);
    /// 0: whole numbers only.
    void setDecimals(int decimals);
    [[nodiscard]] int decimals() const { return m_decimals; }
    void setSingleStep(double step) { m_step = step; }
    /// The width of the field in digits.
    void setDigits(int digits);
    /// The name of the quantity, and its unit, in sentences about the field.
    void setWords(const QString& quantity, const QString& unit);
    /// The tool tip while there is no problem.
    void setMeaning(const QString& meaning);
    /// Like look::setPossible(), but does not hide what the field itself says about its text.
    void setPossible(const QString& reason, const QString& meaning);

    /// Why no number can be shown or entered now: the field has no value and is read-only. Empty: it is
    /// available.
    void setUnavailable(const QString& why);

    /// Empty unless the text is an unambiguous number within the range.
    [[nodiscard]] std::optional<double> value() const;
    [[nodiscard]] Problem problem() const { return m_problem; }
    /// Why there is no value, as a sentence: "Kp must be 0 to 32767."
    [[nodiscard]] QString problemText() const;

    /// Emits nothing.
    void showValue(double value);
    void showNothing();
    /// Shows any text, whether it is a value or not. Emits nothing.
    void showText(const QString& text);

    [[nodiscard]] static std::optional<double> parse(const QString& text, bool wholeOnly, Problem* problem);
    /// With the locale's decimal mark, without group separators and without trailing zeros.
    [[nodiscard]] static QString format(double value, int decimals);

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

signals:
    /// The user has changed the text, whether it is a value or not.
    void edited();

protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void judge();
    void moveBy(int steps);
    /// With at least two significant digits, unless the field is for whole numbers only.
    [[nodiscard]] QString textOf(double value) const;
    /// True within the range, and for a limit as the field itself writes it, which may be rounded to beyond
    /// the range.
    [[nodiscard]] bool isAllowed(double number) const;
    /// True if the typed text may be a decimal fraction or groups of thousands. A number shown by the field
    /// itself is never ambiguous.
    [[nodiscard]] bool isAmbiguous() const;
    /// The text as an unambiguous decimal fraction: 1.2340 for 1,234.
    [[nodiscard]] QString asFraction() const;

    int m_decimals;
    double m_min = 0;
    double m_max = 0;
    double m_step = 1;
    int m_digits = 11;
    int m_wheelRest = 0;
    QString m_quantity;
    QString m_unit;
    QString m_meaning;
    QString m_unavailable;
    QString m_rangeReason;
    Problem m_problem = Problem::Empty;
};

}  // namespace nmc
