// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLineEdit>
#include <QString>
#include <optional>

namespace nmc {

/// A field for one number in one unit (interface.md, "Values"), read alike under every locale, and never by a
/// guess: whole numbers have no mark at all. Elsewhere both , and . are the decimal mark, two are refused,
/// and what was typed as groups are written, 1,234 or 1.234, has no value until Enter has made it 1.2340.
/// What is out of range stays as typed, is marked, says the range, and has no value. The wheel works only in
/// a focused field.
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

    /// `decimals` 0: whole numbers only. Otherwise how many are shown; more may be typed.
    explicit NumberField(int decimals, QWidget* parent = nullptr);

    void setRange(double min, double max);
    /// Which setting makes the range what it is, as a sentence; empty: the module.
    void setRangeReason(const QString& reason);
    /// 0: whole numbers only.
    void setDecimals(int decimals);
    [[nodiscard]] int decimals() const { return m_decimals; }
    void setSingleStep(double step) { m_step = step; }
    /// How many digits it is wide.
    void setDigits(int digits);
    /// What the field is called in the sentence about its range, and what its numbers count.
    void setWords(const QString& quantity, const QString& unit);
    /// What the tool tip says while there is no problem.
    void setMeaning(const QString& meaning);
    /// As look::setPossible() does, and without covering what the field itself says of its text.
    void setPossible(const QString& reason, const QString& meaning);

    /// Why no number can be told or taken now; then there is no value and nothing can be typed. Empty: one
    /// can.
    void setUnavailable(const QString& why);

    /// Empty while what stands there is not one number within the range.
    [[nodiscard]] std::optional<double> value() const;
    [[nodiscard]] Problem problem() const { return m_problem; }
    /// Why there is no value, as a sentence: "Kp takes 0 to 32767."
    [[nodiscard]] QString problemText() const;

    /// Emits nothing.
    void showValue(double value);
    void showNothing();
    /// Whatever stands there, a value or not. Emits nothing.
    void showText(const QString& text);

    [[nodiscard]] static std::optional<double> parse(const QString& text, bool wholeOnly, Problem* problem);
    /// In the locale's decimal mark, without group separators and without trailing zeros.
    [[nodiscard]] static QString format(double value, int decimals);

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

signals:
    /// The user changed what stands there, to a value or not.
    void edited();

protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void judge();
    void moveBy(int steps);
    /// With two digits at least that are no leading zeros.
    [[nodiscard]] QString textOf(double value) const;
    /// Within the range, or what the field itself writes for a limit, which rounding may have put beyond it.
    [[nodiscard]] bool isAllowed(double number) const;
    /// What was typed may be a decimal fraction or a group of thousands. What the field itself shows is none.
    [[nodiscard]] bool isAmbiguous() const;
    /// As a decimal fraction and nothing else: 1.2340 for 1,234.
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
