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
/// and what a step with them would do. Sends nothing.
class ModelBox : public QWidget {
    Q_OBJECT

public:
    /// `runs`: those of the list, newest last; they must outlive it.
    explicit ModelBox(const std::vector<KeptResponse>& runs, QWidget* parent = nullptr);

    // Emit nothing but curvesChanged().
    /// `stepProblem`: why this module can make no step now; empty: it can.
    void showModule(const PanelView& view, const QString& stepProblem);
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
    /// With every move of a slider: a tenth of a second of work.
    void suggestionWanted(const nmc::SuggestionTask& task);
    void gainsWanted(const nmc::servo::SetGain& gains);
    void curvesChanged();
    /// One more step by that, and otherwise with the settings of the form: what was found is not sure yet.
    void stepWanted(std::int32_t counts);

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
    void identify();
    void refresh();
    void suggest();
    void showWords();
    /// The motor was found, though not surely, and of all runs that there are.
    [[nodiscard]] bool wantsStep() const;
    [[nodiscard]] std::vector<const KeptResponse*> ofThisModule() const;
    [[nodiscard]] const Found* found() const;

    QPushButton* m_identify = nullptr;
    QPushButton* m_another = nullptr;
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
    QString m_stepProblem;
    double m_margin;  ///< degrees; the last one that was a number
    int m_asked = 0;  ///< suggestions, so far
    Suggestion m_suggestion;
    std::vector<ResponsePoint> m_fitted;
    std::optional<int> m_about;
};

}  // namespace nmc
