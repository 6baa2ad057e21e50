// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <array>
#include <optional>
#include <vector>

#include "model/response/responsefile.h"
#include "widgets/common/filedialog.h"
#include "widgets/panels/panelview.h"
#include "widgets/response/modelbox.h"
#include "widgets/response/responsetable.h"

class QCheckBox;
class QPushButton;
class QTabWidget;

namespace nmc {

class ResponseForm;
class ResponseResults;
class ResponseView;

/// Step responses of the selected servo: asks for them, keeps those that were made, and compares two.
class ResponsePage : public QWidget {
    Q_OBJECT

public:
    explicit ResponsePage(QWidget* parent = nullptr);

    // Emit nothing.
    void showModule(const PanelView& view);
    void showNothing();
    /// A new one: it becomes A, and where there is no B to compare it with, what was A becomes B. Its number
    /// is given here, and it is judged by the band that the user has chosen.
    void showRun(KeptResponse run);
    /// Those that were kept of the machine, oldest first, below what is there by now.
    void showKept(std::vector<KeptResponse> runs);
    /// The runs are of another machine.
    void clearRuns();
    /// The answer to identifyWanted().
    void showMotor(ModuleIndex module, const FoundMotor& found);
    /// The answer to suggestionWanted().
    void showSuggestion(const Suggestion& suggestion);
    /// What is known of a module is of the last connection; the runs stay.
    void forgetModules();

    /// The form and its sentence, to be laid out elsewhere, until it is taken back.
    [[nodiscard]] QWidget* lendForm();
    void takeFormBack();
    [[nodiscard]] bool lends() const { return m_lent != nullptr; }
    /// As by the form's button.
    void step();
    /// As in ModelBox.
    void find(ModuleIndex module);

    [[nodiscard]] const std::vector<KeptResponse>& runs() const { return m_kept; }
    /// What was found of the motor that is shown; empty for nothing.
    [[nodiscard]] QStringList motorWords() const { return m_model->motorWords(); }

signals:
    void asked(nmc::ModuleIndex module, const nmc::Intent& intent);
    /// Into the fields of the gains of the selected module, which is that of the run; not to be sent.
    void gainsWanted(const nmc::servo::SetGain& gains);
    void suggestionWanted(const nmc::SuggestionTask& task);
    void identifyWanted(nmc::ModuleIndex module, const std::vector<nmc::ResponseRecord>& runs);
    /// runs() has changed, and not by showKept() or clearRuns(): it is to be kept.
    void runsChanged();
    /// All runs, or a picture of those that are shown.
    void saveRequested(const QString& path, const nmc::FileContent& content);
    /// One page, by the system's usual printer.
    void printRequested(const QByteArray& pdf);

private:
    void lay();
    QWidget* newRunsPart();
    QPushButton* newButton(const QString& objectName, const QString& text, const QKeySequence& shortcut);
    void showAs(int which, int run, bool shown);
    void judgeAll(double bandPercent);
    void showModelCurves();
    void useGains();
    void nameRun(int number, const QString& name, const QString& note);
    void removeChosen();
    void putBack();
    void showList();
    void chooseFile();
    void refreshRuns();
    void refreshButtons();
    [[nodiscard]] std::vector<const KeptResponse*> others() const;
    [[nodiscard]] const KeptResponse* find(std::optional<int> number) const;
    [[nodiscard]] QString whyNotUsable(const KeptResponse* run) const;

    std::vector<KeptResponse> m_kept;     ///< oldest first
    std::vector<KeptResponse> m_removed;  ///< the last at the end
    ResponseForm* m_form;
    ResponseResults* m_results;
    ModelBox* m_model;
    QTabWidget* m_findings = nullptr;
    ResponseView* m_view;
    ResponseTable* m_table;
    QWidget* m_runs = nullptr;  ///< the table and its buttons
    QWidget* m_lent = nullptr;  ///< the form, elsewhere
    QPushButton* m_use = nullptr;
    QPushButton* m_remove = nullptr;
    QPushButton* m_putBack = nullptr;
    QPushButton* m_save = nullptr;
    QCheckBox* m_all = nullptr;
    ShownRuns m_shown;
    int m_lastNumber = 0;
    std::optional<ModuleIndex> m_servo;  ///< what is selected, if it is a PIC-SERVO
};

}  // namespace nmc
