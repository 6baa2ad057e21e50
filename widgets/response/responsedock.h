// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/lazydock.h"
#include "widgets/response/responsepage.h"

namespace nmc {

/// The place of the step responses, closed at first: its content is built when it is seen for the first time.
class ResponseDock : public LazyDock {
    Q_OBJECT

public:
    explicit ResponseDock(QWidget* parent = nullptr);

    // As in ResponsePage.
    void showModule(const PanelView& view);
    void showNothing();
    void showRun(KeptResponse run) { page().showRun(std::move(run)); }
    /// Until it is built they wait.
    void showKept(std::vector<KeptResponse> runs);
    void clearRuns();
    [[nodiscard]] std::vector<KeptResponse> runs() const {
        return m_page != nullptr ? m_page->runs() : m_waiting;
    }
    void showMotor(ModuleIndex module, const FoundMotor& found) { page().showMotor(module, found); }
    void showSuggestion(const Suggestion& suggestion) { page().showSuggestion(suggestion); }
    void forgetModules();

    /// As in ResponsePage; nothing while it was not built.
    void takeFormBack();
    /// The content; built if need be.
    ResponsePage& page();

signals:
    void asked(nmc::ModuleIndex module, const nmc::Intent& intent);
    void gainsWanted(const nmc::servo::SetGain& gains);
    void suggestionWanted(const nmc::SuggestionTask& task);
    void identifyWanted(nmc::ModuleIndex module, const std::vector<nmc::ResponseRecord>& runs);
    void runsChanged();
    void saveRequested(const QString& path, const nmc::FileContent& content);
    /// One page, by the system's usual printer.
    void printRequested(const QByteArray& pdf);

private:
    void build() override { page(); }
    [[nodiscard]] bool inUse() const { return seen() || (m_page != nullptr && m_page->lends()); }

    ResponsePage* m_page = nullptr;
    std::vector<KeptResponse> m_waiting;
};

}  // namespace nmc
