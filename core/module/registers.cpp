// SPDX-License-Identifier: MIT
#include "module/registers.h"

#include "base/overloaded.h"

namespace nmc {

void ServoRegisters::apply(const ServoCommand& command, const ModuleIdentity& module) {
    std::visit(Overloaded{
                   [this](const servo::LoadTrajectory& loaded) {
                       load = loaded;
                       loadWaiting = !loaded.startNow;
                       if (loaded.position && !loaded.relative)
                           goal = loaded.position;
                       if (loaded.velocity)
                           velocity = loaded.velocity;
                       if (loaded.acceleration)
                           acceleration = loaded.acceleration;
                       if (loaded.startNow)
                           started();
                   },
                   [this](const StartMotion&) { started(); },
                   [&](const servo::StopMotor& stop) {
                       amplifierEnabled = stop.amplifierEnable;
                       if (stop.manner != servo::StopManner::AmplifierOnly)
                           stopped(stop.manner, module);
                   },
                   [this](const servo::SetGain& set) {
                       gains = set;
                       servoRate = set.sr;
                   },
                   [this](const servo::IoControl& control) {
                       io = control;
                       pathControl = PathControl{control.fastPath, false};
                   },
                   [this](const servo::ScIoControl& control) {
                       scIo = control;
                       pathControl = PathControl{control.fastPath, control.stepAndDirection};
                   },
                   [](const auto& /*other*/) {},
               },
               command);
}

void ServoRegisters::started() {
    loadWaiting = false;
    runningVelocity = velocity;
    runningAcceleration = acceleration;
}

void ServoRegisters::stopped(servo::StopManner manner, const ModuleIdentity& module) {
    loadWaiting = false;
    // DS-V 5.2: only these two set the velocity to 0. CMC and SC keep it (docs/family.md).
    const bool zeroes = manner == servo::StopManner::Abruptly || manner == servo::StopManner::Smoothly;
    if (zeroes && !hasPathBuffer(module))
        velocity = CountsPerTick(0);
}

servo::LoadTrajectory ServoRegisters::trajectory() const {
    servo::LoadTrajectory whole = load;
    if (!load.relative)
        whole.position = goal;
    whole.velocity = velocity;
    whole.acceleration = acceleration;
    return whole;
}

void StepperRegisters::apply(const StepperCommand& command) {
    std::visit(Overloaded{
                   [this](const stepper::LoadTrajectory& load) {
                       waiting.reset();
                       if (load.speed)
                           loadedSpeed = load.speed;
                       if (load.accelerationTime)
                           loadedTime = load.accelerationTime;
                       if (load.startNow)
                           accelerationTime = loadedTime;
                       else
                           waiting = load;
                   },
                   [this](const StartMotion&) {
                       accelerationTime = loadedTime;
                       waiting.reset();
                   },
                   [this](const stepper::SetParameters& set) {
                       // Integer speeds have another meaning in another speed mode.
                       if (!parameters || parameters->speedMode != set.speedMode)
                           waiting.reset();
                       parameters = set;
                   },
                   [this](const stepper::StopMotor& stop) {
                       if (stop.manner != stepper::StopManner::AmplifierOnly)
                           stopped(stop.manner);
                   },
                   [this](const stepper::SetOutputs& set) { outputs = set.outputs; },
                   [](const auto& /*other*/) {},
               },
               command);
}

void StepperRegisters::stopped(stepper::StopManner manner) {
    waiting.reset();
    if (manner == stepper::StopManner::Smoothly)
        loadedSpeed = std::uint8_t{0};
}

void IoRegisters::attached() {
    inputs.reset();
    outputs.reset();
    pwm.reset();
    timer.reset();
    stored.reset();
}

void IoRegisters::doubt(CommandCode command) {
    const bool synch = command == io::SynchOutput::kCode;
    if (synch || command == io::SetOutput::kCode)
        outputs.reset();
    if (synch || command == io::SetPwm::kCode)
        pwm.reset();
    if (command == io::SetSynchOutput::kCode)
        stored.reset();
}

void IoRegisters::apply(const IoCommand& command) {
    std::visit(Overloaded{
                   [this](const io::SetDirection& set) { inputs = set.inputs; },
                   [this](const io::SetOutput& set) { outputs = set.outputs; },
                   [this](const io::SetPwm& set) {
                       pwm = {set.pwm1, set.pwm2};
                   },
                   [this](const io::SetTimerMode& mode) { timer = mode; },
                   [this](const io::SetSynchOutput& set) { stored = set; },
                   [this](const io::SynchOutput&) {
                       outputs.reset();
                       pwm.reset();
                       if (!stored)
                           return;  // the values that another host has stored are unknown
                       outputs = stored->outputs;
                       pwm = {stored->pwm1, stored->pwm2};
                   },
                   [](const auto& /*other*/) {},
               },
               command);
}

}  // namespace nmc
