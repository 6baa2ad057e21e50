// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <map>
#include <optional>
#include <set>
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
class Requests;
class ResponseForm;

using FoundMotor = tl::expected<Identified, IdentifyFailure>;

/// A request for a suggestion.
struct SuggestionTask {
    int id = 0;  ///< only the answer to the latest request counts
    MotorModel motor;
    LoopWish wish;
    servo::SetGain now;
    ResponseTaken taken;  ///< the step that is predicted for the suggested gains
    double bandPercent = 0.0;
};
struct Suggestion {
    int id = 0;
    std::optional<servo::SetGain> gains;  ///< empty: no gains are stable
    std::optional<Prediction> prediction;
};

/// The motor model that explains the step responses of the selected servo, gains suggested for it according
/// to three sliders and a phase margin, and what a step with these gains would do. If the user requests
/// further steps, the form makes them.
class ModelBox : public QWidget {
    Q_OBJECT

public:
    /// `runs`: the runs of the list, newest last. `runs` and `form` must outlive this object.
    ModelBox(const std::vector<KeptResponse>& runs, ResponseForm& form, Requests& requests,
             QWidget* parent = nullptr);

    /// Finds the motor model of a module from its last runs, once those that were wanted before are found.
    void find(ModuleIndex module);

    // Emit at most curvesChanged() and Requests::suggest().
    /// Call it after ResponseForm::showModule().
    void showModule(const PanelView& view);
    void showNothing();
    /// The runs of the list have changed.
    void showRuns();
    /// The numbers of the runs have become higher by this; showRuns() follows.
    void renumber(int by);
    /// The answer to Requests::identify(); ignored if it is no longer expected. May emit the next request.
    void showMotor(ModuleIndex module, const FoundMotor& found);
    /// The answer to Requests::suggest().
    void showSuggestion(const Suggestion& suggestion);
    /// The modules have been replaced.
    void forget();

    /// What a step like the run about() would do with the suggested gains; null if nothing is suggested.
    [[nodiscard]] const Prediction* prediction() const;
    /// The run about() as the motor model reproduces it.
    [[nodiscard]] const std::vector<ResponsePoint>& fittedPoints() const { return m_fitted; }
    /// The constants of the module's motor model, one per line; empty if none was found.
    [[nodiscard]] QStringList motorWords(ModuleIndex module) const;
    /// Number of the last run from which the motor model was found.
    [[nodiscard]] std::optional<int> about() const { return m_about; }

signals:
    void curvesChanged();

private:
    struct Looking {
        ModuleIndex module;
        int from = 0;  ///< number of the last run that is evaluated
    };
    struct Found {
        FoundMotor motor;
        int from = 0;
    };

    QSlider* newSlider(const QString& objectName, const QString& text, const QString& meaning, double first);
    void refresh();
    void refreshButtons();
    void suggest();
    void showWords();
    [[nodiscard]] bool suggesting() const;
    /// A series of steps; or a single one if the motor model is uncertain although it was found from enough
    /// runs, including the last one.
    [[nodiscard]] std::vector<std::int32_t> nextSteps() const;
    [[nodiscard]] std::vector<const KeptResponse*> runsOf(std::optional<ModuleIndex> module) const;
    [[nodiscard]] const Found* found(std::optional<ModuleIndex> module) const;
    [[nodiscard]] const Found* found() const { return found(m_servo); }

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
    Requests& m_requests;
    std::map<ModuleIndex, Found> m_found;
    std::optional<Looking> m_looking;
    std::set<ModuleIndex> m_waiting;  ///< whose motor model is to be found next
    std::optional<ModuleIndex> m_servo;
    std::optional<servo::SetGain> m_gains;  ///< of m_servo
    QString m_locked;                       ///< why they cannot be edited; empty if they can
    double m_margin;                        ///< degrees; the last valid value of the field
    int m_asked = 0;                        ///< number of suggestions requested so far
    Suggestion m_suggestion;
    std::vector<ResponsePoint> m_fitted;
    std::optional<int> m_about;
};

}  // namespace nmc
