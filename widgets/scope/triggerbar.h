// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>
#include <variant>
#include <vector>

#include "model/scope/scopetrigger.h"
#include "widgets/scope/scopemodule.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace nmc {

class FlowLayout;
class NumberField;

/// The controls of the trigger, in which the user chooses what the scope waits for.
class TriggerBar : public QWidget {
    Q_OBJECT

public:
    enum class Mode : std::uint8_t { Off, Single, Normal };

    explicit TriggerBar(QWidget* parent);

    /// Offers the signals of these modules, those of the selected module first.
    void showModules(const std::vector<ScopeModule>& modules, std::optional<ModuleIndex> selected);
    /// Shows the state of the trigger, in words.
    void showState(const QString& state);
    void setMode(Mode mode);
    [[nodiscard]] Mode mode() const;
    /// The chosen settings, except for the window, which the owner sets; empty if the trigger is off or
    /// something is not chosen yet.
    [[nodiscard]] std::optional<TriggerSettings> settings() const;
    /// The signal whose strip shows the level.
    [[nodiscard]] std::optional<SignalRef> levelSignal() const;
    /// Adds controls about what triggered.
    void addControls(QWidget* controls);
    void setVisible(bool visible) override;

signals:
    /// settings() or mode() may have changed.
    void edited();
    void armRequested();

private:
    struct Source {
        std::optional<ModuleIndex> module;  ///< empty: the selected module
        std::variant<ScopeSignal, ScopeBit> what;
        bool operator==(const Source&) const = default;
    };
    /// What the level is a level of, and how it was read in counts.
    struct LevelOf {
        Source source;
        ModuleIndex module;
        LinearScale scale;
    };

    void layOut();
    void addSources(const std::optional<ModuleIndex>& module, const ScopeModule& of);
    void listSources();
    void takeSource();
    void takeSourceAgain();
    void showConditions();
    void showPossible();
    [[nodiscard]] const Source* source() const;
    [[nodiscard]] std::optional<ModuleIndex> sourceModule() const;
    [[nodiscard]] const ScopeSignal* signal() const;
    [[nodiscard]] LinearScale scale() const;

    std::vector<ScopeModule> m_modules;
    std::optional<ModuleIndex> m_selected;
    std::vector<Source> m_sources;              ///< in the order of the box
    bool m_listed = true;                       ///< m_sources are those of m_modules
    std::optional<ModuleIndex> m_sourceModule;  ///< of the chosen source
    std::optional<LevelOf> m_levelOf;
    FlowLayout* m_layout;
    QComboBox* m_source;
    QComboBox* m_condition;
    NumberField* m_level;
    QLabel* m_unit;
    QComboBox* m_mode;
    NumberField* m_before;
    QPushButton* m_arm;
    QLabel* m_state;
};

}  // namespace nmc
