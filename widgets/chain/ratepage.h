// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "model/module/linkstate.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace nmc {

class NumberField;

/// The rate of the whole chain, changed while it runs: every module is asked at the new rate, and all go back
/// when one does not follow.
class RatePage : public QWidget {
    Q_OBJECT

public:
    explicit RatePage(QWidget* parent = nullptr);

    /// Emits nothing.
    void showLink(const LinkState& link);

signals:
    void rateRequested(quint32 baud);

private:
    void refresh();
    /// Empty while no divisor stands in its field.
    [[nodiscard]] std::optional<quint32> wanted() const;

    QLabel* m_now;
    QComboBox* m_rate;
    NumberField* m_divisor;  ///< of any other rate
    QLabel* m_other;
    QPushButton* m_change;
    QLabel* m_reason;  ///< why not, for whoever does not look for a tool tip
    /// Why the bus would refuse it (bus::RateChangeFailed); empty: it would not.
    [[nodiscard]] QString whyNot() const;

    LinkState m_link;
};

}  // namespace nmc
