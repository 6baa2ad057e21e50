// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
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

class Requests;
class ResponseForm;
class ResponseResults;
class ResponseView;

/// Step responses of the selected servo: requests them, keeps those that were recorded, and compares two.
class ResponsePage : public QWidget {
    Q_OBJECT

public:
    explicit ResponsePage(Requests& requests, QWidget* parent = nullptr);

    // Emit at most Requests::suggest(), and showRun() also Requests::storeRuns().
    void showModule(const PanelView& view);
    void showNothing();
    /// Adds a new run: it becomes A and, if there is no B to compare it with, the previous A becomes B. Its
    /// number is assigned here, and it is evaluated with the settling band that the user has chosen.
    void showRun(KeptResponse run);
    /// Adds the runs that are stored with the machine, oldest first, below those already in the list.
    void showKept(std::vector<KeptResponse> runs);
    /// Removes all runs. Call it when the machine is replaced.
    void clearRuns();
    /// Forgets what is known about the modules, which are those of the last connection; the runs stay, but
    /// say nothing about the motors that are connected now.
    void forgetModules();

    /// Returns the form with its state label, to be placed elsewhere until takeFormBack().
    [[nodiscard]] QWidget* lendForm();
    void takeFormBack();
    [[nodiscard]] bool lends() const { return m_lent != nullptr; }
    /// Makes a step as the form's button does.
    void step();

    [[nodiscard]] const std::vector<KeptResponse>& runs() const { return m_kept; }
    [[nodiscard]] ModelBox& model() { return *m_model; }

private:
    void lay();
    QWidget* newRunsPart();
    QPushButton* newButton(const QString& objectName, const QString& text, const QKeySequence& shortcut);
    void showAs(int which, int run, bool shown);
    void judge(KeptResponse& kept) const;
    void judgeAll();
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

    Requests& m_requests;
    std::vector<KeptResponse> m_kept;     ///< oldest first
    std::vector<KeptResponse> m_removed;  ///< the one removed last at the end
    ResponseForm* m_form;
    ResponseResults* m_results;
    ModelBox* m_model;
    QTabWidget* m_findings = nullptr;
    ResponseView* m_view;
    ResponseTable* m_table;
    QWidget* m_runs = nullptr;  ///< the table and its buttons
    QWidget* m_lent = nullptr;  ///< contains the form while it is placed elsewhere
    QPushButton* m_use = nullptr;
    QPushButton* m_remove = nullptr;
    QPushButton* m_putBack = nullptr;
    QPushButton* m_save = nullptr;
    QCheckBox* m_all = nullptr;
    ShownRuns m_shown;
    int m_lastNumber = 0;
    std::optional<ModuleIndex> m_servo;  ///< the selected module, if it is a PIC-SERVO
    QString m_locked;                    ///< why its gains cannot be edited; empty if they can
};

}  // namespace nmc
