// Parameters of Muster's gaits, fitted to measurements of people (docs/method/motion-generator.md).
#include "people/generator/clip_maker.h"
#include "people/generator/gait.h"

namespace muster::generator {
namespace {

double frames(int count) {
    return count / kFrameRate;
}

}  // namespace

Gait walkGait() {
    Gait gait;
    gait.cycle = frames(64);
    gait.speed = 1.25;
    gait.contact = 0.60;
    gait.footForward = -0.098;
    gait.footOut = 0.055;
    gait.toeOut = degrees(7);
    gait.strike = degrees(20);
    gait.flat = 0.09;
    gait.heelRise = 0.22;
    gait.push = degrees(58);
    gait.swing = {{swingKey(0.25, 11), swingKey(0.5, 28), swingKey(0.75, 31)},
                  {swingKey(0.28, 71), swingKey(0.5, 64), swingKey(0.75, 30)},
                  {swingKey(0.13, -15), swingKey(0.30, 2), swingKey(0.6, 11)}};
    gait.height = 0.911;
    gait.bob = 0.028;
    gait.surge = 0.008;
    gait.sway = 0.022;
    gait.pelvisPitch = degrees(4);
    gait.pelvisYaw = degrees(5);
    gait.pelvisRoll = degrees(4);
    gait.lean = degrees(2);
    gait.nod = degrees(1);
    gait.chestYaw = degrees(6);
    gait.chestRoll = degrees(1.5);
    gait.headPitch = degrees(2);
    gait.arm = {degrees(-5), degrees(20), 0.03};
    gait.armOut = degrees(9);
    gait.armTurn = degrees(18);
    gait.armAcross = degrees(8);
    gait.elbow = {degrees(36), degrees(22), 0.06};
    gait.wrist = degrees(8);
    return gait;
}

Gait jogGait() {
    Gait gait;
    gait.cycle = frames(45);
    gait.speed = 1.95;
    gait.contact = 0.34;
    gait.footForward = -0.14;
    gait.footOut = 0.04;
    gait.toeOut = degrees(6);
    gait.strike = degrees(8);
    gait.flat = 0.05;
    gait.heelRise = 0.22;
    gait.push = degrees(48);
    gait.swing = {
        {swingKey(0.08, -10), swingKey(0.26, 1), swingKey(0.42, 21), swingKey(0.56, 35), swingKey(0.72, 32)},
        {swingKey(0.26, 74), swingKey(0.42, 98), swingKey(0.52, 97), swingKey(0.71, 56), swingKey(0.86, 32)},
        {swingKey(0.07, -12), swingKey(0.16, -5), swingKey(0.275, 6), swingKey(0.5, 12), swingKey(0.75, 17)}};
    gait.height = 0.915;
    gait.lift = 0.03;
    gait.surge = 0.008;
    gait.sway = 0.012;
    gait.pelvisPitch = degrees(6);
    gait.pelvisYaw = degrees(6);
    gait.pelvisRoll = degrees(4);
    gait.lean = degrees(6);
    gait.nod = degrees(2);
    gait.chestYaw = degrees(10);
    gait.chestRoll = degrees(2);
    gait.headPitch = degrees(3);
    gait.arm = {degrees(-8), degrees(28), 0.02};
    gait.armOut = degrees(12);
    gait.armTurn = degrees(14);
    gait.armAcross = degrees(10);
    gait.elbow = {degrees(97), degrees(10), 0.1};
    return gait;
}

Gait runGait() {
    Gait gait = jogGait();
    gait.speed = 2.6;
    gait.contact = 0.31;
    gait.footForward = -0.15;
    gait.push = degrees(54);
    gait.swing = {
        {swingKey(0.10, -15), swingKey(0.275, 1), swingKey(0.42, 24), swingKey(0.565, 39),
         swingKey(0.71, 36)},
        {swingKey(0.09, 40), swingKey(0.275, 82), swingKey(0.42, 107), swingKey(0.52, 105),
         swingKey(0.71, 60), swingKey(0.86, 32)},
        {swingKey(0.06, -13), swingKey(0.15, -6), swingKey(0.275, 6), swingKey(0.5, 13), swingKey(0.75, 20)}};
    gait.height = 0.912;
    gait.lift = 0.026;
    gait.lean = degrees(9);
    gait.pelvisPitch = degrees(8);
    gait.pelvisYaw = degrees(8);
    gait.chestYaw = degrees(13);
    gait.arm = {degrees(-8), degrees(38), 0.02};
    gait.elbow = {degrees(98), degrees(17), 0.1};
    return gait;
}

Gait sprintGait() {
    Gait gait = runGait();
    gait.cycle = frames(39);
    gait.speed = 3.8;
    gait.contact = 0.27;
    gait.footForward = -0.165;
    gait.footOut = 0.03;
    gait.strike = degrees(3);
    gait.push = degrees(66);
    gait.swing = {
        {swingKey(0.08, -20), swingKey(0.275, 6), swingKey(0.42, 36), swingKey(0.565, 56),
         swingKey(0.71, 50)},
        {swingKey(0.275, 90), swingKey(0.42, 120), swingKey(0.52, 117), swingKey(0.71, 72),
         swingKey(0.86, 36)},
        {swingKey(0.06, -13), swingKey(0.15, -6), swingKey(0.275, 6), swingKey(0.5, 13), swingKey(0.75, 18)}};
    gait.height = 0.893;
    gait.lift = 0.03;
    gait.lean = degrees(13);
    gait.pelvisPitch = degrees(11);
    gait.pelvisYaw = degrees(10);
    gait.chestYaw = degrees(15);
    gait.arm = {degrees(-4), degrees(50), 0.02};
    gait.elbow = {degrees(96), degrees(18), 0.1};
    return gait;
}

Gait duckGait() {
    Gait gait;
    gait.cycle = frames(54);
    gait.speed = 1.04;
    gait.contact = 0.58;
    gait.footForward = -0.07;
    gait.footOut = 0.085;
    gait.toeOut = degrees(10);
    gait.strike = degrees(10);
    gait.flat = 0.08;
    gait.heelRise = 0.24;
    gait.push = degrees(50);
    gait.swing = {{swingKey(0.5, 62)},
                  {swingKey(0.38, 106), swingKey(0.7, 92)},
                  {swingKey(0.35, 8), swingKey(0.7, 12)}};
    gait.height = 0.70;
    gait.bob = 0.016;
    gait.surge = 0.006;
    gait.sway = 0.022;
    gait.forward = -0.10;
    gait.pelvisPitch = degrees(38);
    gait.pelvisYaw = degrees(7);
    gait.pelvisRoll = degrees(4);
    gait.lean = degrees(62);
    gait.nod = degrees(1.5);
    gait.chestYaw = degrees(7);
    gait.headPitch = degrees(18);
    gait.arm = {degrees(42), degrees(20), 0.03};
    gait.armOut = degrees(16);
    gait.armTurn = degrees(25);
    gait.elbow = {degrees(70), degrees(12), 0.08};
    return gait;
}

}  // namespace muster::generator
