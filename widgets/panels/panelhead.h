// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <array>

#include "widgets/panels/modulecontext.h"

class QGridLayout;
class QHBoxLayout;
class QLabel;

namespace nmc {

class Command;
class ElidedLabel;
class GlyphLabel;

/// Head of the page of a module, always visible: which module it is, its state as a shape and words, position
/// and velocity in large digits, what stops or powers it, and the controls that switch and stop this one
/// motor.
class PanelHead : public QFrame {
    Q_OBJECT

public:
    /// The object names of a stepper's controls begin with "stepper": stepperEnableButton.
    PanelHead(ModuleContext& context, QWidget* parent);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    /// A mark and a word.
    struct Sign {
        GlyphLabel* glyph = nullptr;
        QLabel* word = nullptr;
    };

    [[nodiscard]] bool isServo() const { return m_context.state().isServo(); }
    Command* addCommand(const QString& icon, const QString& text, const QString& objectName,
                        const QString& accessibleName, const Intent& intent, const QKeySequence& key = {});
    Sign newSign(const QString& objectName, const QString& meaning);
    void build();
    void arrange(bool narrow);
    void arrangeWide(QGridLayout& grid, QHBoxLayout* what);
    void arrangeNarrow(QGridLayout& grid, QHBoxLayout* what);
    [[nodiscard]] QHBoxLayout* row(std::initializer_list<QWidget*> widgets) const;
    [[nodiscard]] QHBoxLayout* signs() const;
    void refresh();
    void refreshPosition();
    void refreshSigns();
    void refreshCommands();

    ModuleContext& m_context;
    GlyphLabel* m_glyph;
    QLabel* m_name;
    QLabel* m_type;
    QLabel* m_state;
    ElidedLabel* m_meaning;
    QLabel* m_procedure;
    QLabel* m_position;
    QLabel* m_positionUnit;
    QLabel* m_otherPosition;
    QLabel* m_work;  ///< what the position counts from
    QLabel* m_velocity;
    QLabel* m_home;
    QLabel* m_current;
    QLabel* m_travel = nullptr;
    QLabel* m_limitStop = nullptr;
    std::array<Sign, 2> m_limits;
    Sign m_power;
    Command* m_enable;
    Command* m_stopSmoothly;
    Command* m_stopAbruptly;
    Command* m_stopHere = nullptr;
    Command* m_motorOff;
    bool m_narrow = false;
};

}  // namespace nmc
