// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGroupBox>
#include <QHash>
#include <array>
#include <functional>
#include <optional>

#include "model/intent.h"

class QGridLayout;
class QLabel;
class QPushButton;

namespace nmc {

class HoldButton;
class NumberField;

/// Go to a position, run at a velocity, move while held. Each value stands in the chip's unit with what it
/// comes to in seconds beside it.
class MotionBox : public QGroupBox {
    Q_OBJECT

public:
    using WhyNot = std::function<std::optional<Refusal>(Request)>;

    explicit MotionBox(QWidget* parent = nullptr);

    /// Emits nothing, except that a hold ends when its module or its permission goes.
    void showModule(const ModuleState& module, const WhyNot& whyNot);
    /// A click was passed on; moves wait for the module's next word.
    void setBusy(bool busy);
    /// A new connection: low speeds again.
    void resetSpeeds();
    void endHold();
    void setHoldInterval(int milliseconds);

signals:
    void intentRequested(const nmc::Intent& intent);
    void holdRequested(const nmc::bus::HoldToMove& hold);
    void holdReleased();

private:
    struct Quantity {
        NumberField* field = nullptr;
        QLabel* perSecond = nullptr;
        bool acceleration = false;
    };

    void build();
    Quantity addQuantity(QGridLayout* grid, int line, const QString& label, const QString& objectName,
                         const QString& accessibleName, bool acceleration);
    void addTitle(QGridLayout* grid, int line, const QString& text, const QString& remark);
    void connectControls();
    void go();
    void run(bool reverse);
    void hold(bool reverse);
    void refresh();
    void refreshConversions();
    [[nodiscard]] QString reasonFor(Request request, std::initializer_list<const NumberField*> fields) const;

    NumberField* m_goal = nullptr;
    Quantity m_velocity;
    Quantity m_acceleration;
    Quantity m_runVelocity;
    Quantity m_holdVelocity;
    QPushButton* m_go = nullptr;
    QPushButton* m_runForward = nullptr;
    QPushButton* m_runReverse = nullptr;
    HoldButton* m_holdForward = nullptr;
    HoldButton* m_holdReverse = nullptr;
    QLabel* m_hint = nullptr;

    struct Draft {
        std::array<QString, 5> texts;
    };
    [[nodiscard]] std::array<NumberField*, 5> fields() const;
    QHash<int, Draft> m_drafts;
    std::optional<ModuleIndex> m_module;
    WhyNot m_whyNot;
    int m_servoRate = 1;
    bool m_busy = false;
};

}  // namespace nmc
