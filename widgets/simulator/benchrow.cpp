// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/simulator/benchrow.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <cmath>

#include "widgets/common/form.h"
#include "widgets/common/look.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
/// Enough digits for every quantity, but too few to show that 0.015 is not a binary fraction.
constexpr int kSentDigits = 12;
}  // namespace

BenchRow::BenchRow(BenchQuantity quantity, const QString& prefix, QWidget* parent)
    : QObject(parent), m_quantity(std::move(quantity)) {
    const QString base = prefix + m_quantity.name;
    m_field = new NumberField(m_quantity.decimals, parent);
    look::name(m_field, base + u"Field"_s, m_quantity.label);
    m_field->setRange(m_quantity.min, m_quantity.max);
    m_field->setSingleStep(m_quantity.step);
    m_field->setDigits(8);
    m_field->setWords(m_quantity.label, m_quantity.unit);
    m_field->setMeaning(m_quantity.meaning);
    m_unit = look::newMutedLabel(m_quantity.unit, parent);
    if (m_quantity.none.isEmpty()) {
        m_label = form::newLabel(m_quantity.label, m_field);
    } else {
        m_exists = form::newCheck({base + u"Box"_s, m_quantity.label}, parent);
        m_label = m_exists;
        m_field->setEnabled(false);
        connect(m_exists, &QAbstractButton::clicked, this, &BenchRow::turn);
    }
    m_label->setToolTip(m_quantity.meaning);
    if (m_quantity.sliderMin < m_quantity.sliderMax)
        addSlider(base, parent);
    // A step gives a complete number; typing is complete when the field says so.
    connect(m_field, &NumberField::edited, this, [this] {
        if (!m_field->isModified())
            commit();
    });
    connect(m_field, &QLineEdit::editingFinished, this, [this] {
        if (m_field->isModified())
            commit();
    });
}

void BenchRow::addSlider(const QString& prefix, QWidget* parent) {
    m_slider = new QSlider(Qt::Horizontal, parent);
    look::name(m_slider, prefix + u"Slider"_s, m_quantity.label);
    m_slider->setRange(static_cast<int>(std::lround(m_quantity.sliderMin / m_quantity.step)),
                       static_cast<int>(std::lround(m_quantity.sliderMax / m_quantity.step)));
    m_slider->setToolTip(m_quantity.meaning);
    m_slider->setFocusPolicy(Qt::StrongFocus);
    connect(m_slider, &QSlider::valueChanged, this, [this](int steps) {
        m_field->showValue(steps * m_quantity.step);
        commit();
    });
}

void BenchRow::addTo(QGridLayout& grid) {
    int line = grid.rowCount();
    grid.addWidget(m_label, line, 0);
    grid.addWidget(m_field, line, 1);
    grid.addWidget(m_unit, line, 2);
    if (m_slider != nullptr)
        grid.addWidget(m_slider, ++line, 0, 1, 3);
}

void BenchRow::commit() {
    if (m_field->problem() == NumberField::Problem::Empty)
        m_field->setModified(false);  // the present value will be shown again
    const std::optional<double> value = m_field->value();
    if (!value.has_value())
        return;
    m_field->setModified(false);
    showNumber(*value);
    emit entered(m_quantity.name, QString::number(*value * m_quantity.scale, 'g', kSentDigits));
}

void BenchRow::turn(bool on) {
    m_field->setEnabled(on);
    if (!on) {
        forget();
        emit entered(m_quantity.name, m_quantity.none);
        return;
    }
    m_field->showValue(m_proposal);
    commit();
}

void BenchRow::showValue(const QJsonValue& value) {
    const bool exists = value.isDouble();
    if (m_exists != nullptr) {
        m_exists->setChecked(exists);
        m_field->setEnabled(exists);
    }
    if (!exists) {
        forget();
    } else if (!m_field->isModified() && (m_slider == nullptr || !m_slider->isSliderDown())) {
        const double number = value.toDouble() / m_quantity.scale;
        m_field->showValue(number);
        showNumber(number);
    }
}

void BenchRow::showNumber(double value) {
    if (m_slider == nullptr)
        return;
    const QSignalBlocker blocker(m_slider);
    m_slider->setValue(static_cast<int>(std::lround(value / m_quantity.step)));
}

void BenchRow::forget() {
    m_field->showNothing();
    m_field->setModified(false);
}

}  // namespace nmc
