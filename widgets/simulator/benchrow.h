// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonValue>
#include <QObject>
#include <QString>

class QAbstractButton;
class QGridLayout;
class QSlider;
class QWidget;

namespace nmc {

class NumberField;

/// A quantity of the simulator's bench: its name in the control lines, its texts, and the range that makes
/// sense.
struct BenchQuantity {
    QString name{};
    QString label{};
    QString unit{};
    QString meaning{};
    int decimals = 0;
    double scale = 1;  ///< value in the control line for 1 in the unit shown
    double min = 0;    ///< in the unit shown, like max, step and the slider's range
    double max = 0;
    double step = 1;
    double sliderMin = 0;  ///< no slider if both are 0
    double sliderMax = 0;
    QString none{};  ///< the control line's word for "no value"; empty if there always is one
};

/// One number of the bench: a field, a slider if that helps, and a check box if there may be no number. Acts
/// when a number is complete (Enter, leaving the field, a step, the slider), not on every key: "-5000" begins
/// with a -5 that is not meant.
class BenchRow : public QObject {
    Q_OBJECT

public:
    /// Object names begin with `prefix`.
    BenchRow(BenchQuantity quantity, const QString& prefix, QWidget* parent);

    /// Takes the next one or two lines of a grid of three columns: label, field, unit.
    void addTo(QGridLayout& grid);
    /// Shows the simulator's present value; null: none. A number being typed is kept. Emits nothing.
    void showValue(const QJsonValue& value);
    /// The value to start with when the user checks the box.
    void setProposal(double value) { m_proposal = value; }
    /// Discards what was typed, because the value of another module follows.
    void forget();
    [[nodiscard]] const QString& name() const { return m_quantity.name; }

signals:
    /// `value` in the form for the control line.
    void entered(const QString& name, const QString& value);

private:
    void addSlider(const QString& prefix, QWidget* parent);
    void commit();
    void turn(bool on);
    void showNumber(double value);

    BenchQuantity m_quantity;
    QWidget* m_label = nullptr;
    QAbstractButton* m_exists = nullptr;  ///< serves as the label
    NumberField* m_field = nullptr;
    QWidget* m_unit = nullptr;
    QSlider* m_slider = nullptr;
    double m_proposal = 0;
};

}  // namespace nmc
