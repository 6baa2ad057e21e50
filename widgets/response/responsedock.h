// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/lazydock.h"
#include "widgets/response/responsepage.h"

namespace nmc {

/// The dock of the step responses, closed at first: its content is built when it is first shown or needed.
class ResponseDock : public PageDock<ResponsePage> {
    Q_OBJECT

public:
    explicit ResponseDock(Requests& requests, QWidget* parent = nullptr);

    // As in ResponsePage.
    void showModule(const PanelView& view);
    void showNothing();
    void showRun(KeptResponse run) { page().showRun(std::move(run)); }
    /// Until the content is built, the runs are stored here.
    void showKept(std::vector<KeptResponse> runs);
    void clearRuns();
    [[nodiscard]] std::vector<KeptResponse> runs() const {
        return m_page != nullptr ? m_page->runs() : m_waiting;
    }

private:
    void showSoFar() override;
    [[nodiscard]] bool inUse() const { return seen() || (m_page != nullptr && m_page->lends()); }

    std::vector<KeptResponse> m_waiting;
};

}  // namespace nmc
