// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "link/files/inbackground.h"
#include "tests/support/panel.h"
#include "tests/support/virtualchain.h"

namespace nmc::testing_support {

/// The whole program at a chain in virtual time: time passes on the bus and in the window while a test waits,
/// and stands still otherwise. So the same test is the same session each time, on any machine.
class VirtualPanel : public IntentPanel {
public:
    /// The parameters are those of IntentPanel.
    explicit VirtualPanel(const QString& settings = {}, PortController::Places places = noAdapters(),
                          const QString& data = {}, const FileWriter::Disk& disk = writeFile)
        : IntentPanel(settings, std::move(places), data, disk) {
        setBackground([](const std::function<void()>& work) { work(); });
        composition().connection().setTransports([this](const ConnectTarget& target) {
            m_port = target.port;
            VirtualChain* chain = VirtualChain::at(m_port);
            if (chain == nullptr)
                qFatal("There is no chain at %s.", qPrintable(m_port));
            return chain->transport();
        });
    }
    /// The program would wait for its bus thread, for which time passes only while a test waits here.
    ~VirtualPanel() override {
        composition().worker().close();
        for (VirtualChain* chain = VirtualChain::at(m_port); chain != nullptr && chain->open();)
            VirtualChain::runAll(kFrame);
    }

    /// The adapters of this machine are not part of the session, and looking for them would be a third of the
    /// GUI thread's work.
    static PortController::Places noAdapters() {
        PortController::Places places;
        places.list = [] { return QList<PortEntry>(); };
        return places;
    }

    /// Performs a step by calling `start`, and expects a record without missing samples.
    template <typename Start>
    void step(Start start) {
        auto* runs = window().findChild<QTableWidget*>(QStringLiteral("responseRunTable"));
        const int before = runs->rowCount();
        ASSERT_NO_FATAL_FAILURE(start());
        ASSERT_TRUE(waitFor([&] { return runs->rowCount() > before; }))
            << window().findChild<QLabel*>(QStringLiteral("responseState"))->text().toStdString();
        const auto* results = window().findChild<QTableWidget*>(QStringLiteral("responseResults"));
        EXPECT_TRUE(results->findItems(QStringLiteral("samples missing, repeat"), Qt::MatchExactly).empty());
    }
    /// The adapter of a chain is unplugged, and the window says so.
    void unplug(VirtualChain& chain) {
        chain.unplug();
        ASSERT_TRUE(waitFor([this] { return count(QStringLiteral("was unplugged")) == 1; }));
    }
    void pressEsc() { QTest::keyPress(window().windowHandle(), Qt::Key_Escape); }
    /// Lets time pass on the bus only, as if the window were busy.
    void freeze(Duration time) { VirtualChain::runAll(time); }

protected:
    bool wait(const std::function<bool()>& predicate) override {
        for (Duration waited{}; !predicate(); waited += kFrame) {
            if (waited > kPatience)
                return false;
            VirtualChain::runAll(kFrame);
            QCoreApplication::processEvents();
            QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        }
        return true;
    }

private:
    static constexpr Duration kFrame = std::chrono::milliseconds(10);
    static constexpr Duration kPatience = std::chrono::seconds(20);

    QString m_port;  ///< the port opened last
};

}  // namespace nmc::testing_support
