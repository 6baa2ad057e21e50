// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <map>
#include <optional>
#include <vector>

#include "model/response/responsefile.h"
#include "model/tuning/identify.h"
#include "model/tuning/predict.h"
#include "model/tuning/suggest.h"
#include "widgets/panels/panelview.h"

class QLabel;
class QPushButton;
class QSlider;

namespace nmc {

class NumberField;
class ResponseForm;

using FoundMotor = tl::expected<Identified, IdentifyFailure>;

/// What a suggestion is asked for with.
struct SuggestionTask {
    int id = 0;  ///< only the answer to the latest counts
    MotorModel motor;
    LoopWish wish;
    servo::SetGain now;
    ResponseTaken taken;  ///< the step that is predicted once more
    double bandPercent = 0.0;
};
struct Suggestion {
    int id = 0;
    std::optional<servo::SetGain> gains;  ///< empty: none are stable
    std::optional<Prediction> prediction;
};

/// The motor that explains the step responses of the selected servo, gains suggested for it by three sliders,
/// and what a step with them would do. Has steps made by the form, where it is asked for more of them.
class ModelBox : public QWidget {
    Q_OBJECT

public:
    /// `runs`: those of the list, newest last. It and `form` must outlive this.
    ModelBox(const std::vector<KeptResponse>& runs, ResponseForm& form, QWidget* parent = nullptr);

    /// Finds the motor of that module from its last runs.
    void find(ModuleIndex module);

    // Emit nothing but curvesChanged().
    /// The form shows it already.
    void showModule(const PanelView& view);
    void showNothing();
    /// The runs of the list are others.
    void showRuns();
    /// The answer to identifyWanted(); nothing where it is not waited for any more.
    void showMotor(ModuleIndex module, const FoundMotor& found);
    /// The answer to suggestionWanted().
    void showSuggestion(const Suggestion& suggestion);
    /// The modules are others.
    void forget();

    /// What a step like the last of this module would do with the suggested gains; null: nothing is
    /// suggested.
    [[nodiscard]] const Prediction* prediction() const;
    /// How the motor that was found explains that last one.
    [[nodiscard]] const std::vector<ResponsePoint>& fittedPoints() const { return m_fitted; }
    /// The motor that was found, a line each; empty: none was.
    [[nodiscard]] QStringList motorWords() const;
    /// The number of that last one.
    [[nodiscard]] std::optional<int> about() const { return m_about; }

signals:
    void identifyWanted(nmc::ModuleIndex module, const std::vector<nmc::ResponseRecord>& runs);
    /// With every move of a slider: some tenths of a second of work.
    void suggestionWanted(const nmc::SuggestionTask& task);
    void gainsWanted(const nmc::servo::SetGain& gains);
    void curvesChanged();

private:
    struct Looking {
        ModuleIndex module;
        int from = 0;  ///< the number of the last run that is looked at
    };
    struct Found {
        FoundMotor motor;
        int from = 0;
    };

    QSlider* newSlider(const QString& objectName, const QString& text, const QString& meaning, double first);
    void refresh();
    void refreshSteps();
    void suggest();
    void showWords();
    /// A series; or one, where a motor was found from enough of them, and of all that there are, though not
    /// surely.
    [[nodiscard]] std::vector<std::int32_t> nextSteps() const;
    [[nodiscard]] std::vector<const KeptResponse*> runsOf(std::optional<ModuleIndex> module) const;
    [[nodiscard]] const Found* found() const;

    ResponseForm& m_form;
    QPushButton* m_identify = nullptr;
    QPushButton* m_steps = nullptr;
    QPushButton* m_fill = nullptr;
    QLabel* m_motor = nullptr;
    QLabel* m_suggested = nullptr;
    QSlider* m_stiffness = nullptr;
    QSlider* m_damping = nullptr;
    QSlider* m_noise = nullptr;
    NumberField* m_phase = nullptr;
    const std::vector<KeptResponse>& m_runs;
    std::map<ModuleIndex, Found> m_found;
    std::optional<Looking> m_looking;
    std::optional<ModuleIndex> m_servo;
    std::optional<servo::SetGain> m_gains;  ///< that it has
    double m_margin;                        ///< degrees; the last one that was a number
    int m_asked = 0;                        ///< suggestions, so far
    Suggestion m_suggestion;
    std::vector<ResponsePoint> m_fitted;
    std::optional<int> m_about;
};

}  // namespace nmc
