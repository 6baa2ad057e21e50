// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "model/module/linkstate.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace nmc {

class NumberField;
class Requests;

/// Changes the baud rate of the whole chain while it is connected: every module is queried at the new rate,
/// and all go back if one does not answer.
class RatePage : public QWidget {
    Q_OBJECT

public:
    explicit RatePage(Requests& requests, QWidget* parent = nullptr);

    /// Emits nothing.
    void showLink(const LinkState& link);

private:
    void refresh();
    /// The selected rate; empty if it needs a divisor and the field has no value.
    [[nodiscard]] std::optional<quint32> wanted() const;

    Requests& m_requests;
    QLabel* m_now;
    QComboBox* m_rate;
    NumberField* m_divisor;  ///< for any other rate
    QLabel* m_other;
    QPushButton* m_change;
    QLabel* m_reason;  ///< why not, for users who do not look at the tool tip
    /// Why the rate cannot be changed now, mostly as in bus::RateChangeFailed; empty if it can.
    [[nodiscard]] QString whyNot() const;

    LinkState m_link;
};

}  // namespace nmc
