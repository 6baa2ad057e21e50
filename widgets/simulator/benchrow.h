// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonValue>
#include <QObject>
#include <QString>
#include <optional>

class QAbstractButton;
class QGridLayout;
class QSlider;
class QWidget;

namespace nmc {

class NumberField;

/// A quantity of the simulated bench: its name in the control lines, its words, and the range that makes
/// sense.
struct BenchQuantity {
    QString name{};
    QString label{};
    QString unit{};
    QString meaning{};
    int decimals = 0;
    double scale = 1;  ///< what the control line counts in one of the unit shown
    double min = 0;    ///< in the unit shown, as are the others below
    double max = 0;
    double step = 1;
    double sliderMin = 0;  ///< no slider where both are 0
    double sliderMax = 0;
    QString none{};  ///< the control line's word for "no value"; empty: there always is one
};

/// One number of the bench: a field, where it helps a slider, and where it may be absent a check box. Acts
/// when a number is finished (Enter, leaving the field, a step, the slider), not with every key: "-5000"
/// begins with a -5 that nobody meant.
class BenchRow : public QObject {
    Q_OBJECT

public:
    /// Object names begin with `prefix`.
    BenchRow(BenchQuantity quantity, const QString& prefix, QWidget* parent);

    /// Takes the next one or two lines of a grid of three columns: label, field, unit.
    void addTo(QGridLayout& grid);
    /// The simulator's present value; null: none. Leaves what the user is just typing alone. Emits nothing.
    void showValue(const QJsonValue& value);
    /// What to begin with when the user wants a value where none was.
    void setProposal(double value) { m_proposal = value; }
    /// Forgets what was typed: another module's value comes next.
    void forget();
    [[nodiscard]] const QString& name() const { return m_quantity.name; }

signals:
    /// `value` as the control line takes it.
    void entered(const QString& name, const QString& value);

private:
    void addSlider(const QString& prefix, QWidget* parent);
    void commit();
    void turn(bool on);
    void showNumber(double value);

    BenchQuantity m_quantity;
    QWidget* m_label = nullptr;
    QAbstractButton* m_exists = nullptr;  ///< is the label then
    NumberField* m_field = nullptr;
    QWidget* m_unit = nullptr;
    QSlider* m_slider = nullptr;
    double m_proposal = 0;
};

}  // namespace nmc
