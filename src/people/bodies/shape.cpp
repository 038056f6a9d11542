#include "people/bodies/shape.h"

namespace muster::bodies {

const Shape& broadShape() {
    static constexpr Section kPelvis[]{{0.885f, 0.171f, 0.098f, 0.128f, true},
                                       {0.918f, 0.162f, 0.095f, 0.116f},
                                       {0.945f, 0.148f, 0.088f, 0.096f, true}};
    static constexpr Section kShirtRings[]{
        {0.905f, 0.181f, 0.113f, 0.138f, true}, {0.960f, 0.175f, 0.114f, 0.126f},
        {1.030f, 0.165f, 0.113f, 0.108f, true}, {1.100f, 0.163f, 0.114f, 0.101f},
        {1.170f, 0.169f, 0.120f, 0.106f},       {1.245f, 0.179f, 0.129f, 0.117f},
        {1.315f, 0.187f, 0.132f, 0.124f, true}, {1.385f, 0.184f, 0.122f, 0.124f},
        {1.446f, 0.168f, 0.088f, 0.106f, true}, {1.474f, 0.116f, 0.066f, 0.090f},
        {1.496f, 0.067f, 0.056f, 0.070f, true}};
    static constexpr Section kLeg[]{
        {0.770f, 0.086f, 0.096f, 0.101f, false, 0.091f}, {0.690f, 0.080f, 0.092f, 0.087f, true, 0.092f},
        {0.550f, 0.066f, 0.077f, 0.068f, true, 0.090f},  {0.505f, 0.063f, 0.075f, 0.064f, false, 0.090f},
        {0.465f, 0.061f, 0.070f, 0.065f, true, 0.090f},  {0.410f, 0.061f, 0.063f, 0.075f, false, 0.090f},
        {0.340f, 0.060f, 0.058f, 0.080f, false, 0.090f}, {0.260f, 0.055f, 0.054f, 0.070f, false, 0.090f},
        {0.082f, 0.054f, 0.061f, 0.065f, true, 0.090f}};
    static constexpr Section kSleeve[]{{0.205f, 0.061f, 0.063f, 0.065f, false, 1.406f},
                                       {0.245f, 0.062f, 0.062f, 0.063f, false, 1.408f},
                                       {0.335f, 0.060f, 0.060f, 0.058f, true, 1.408f}};
    static constexpr Section kArm[]{
        {0.315f, 0.046f, 0.046f, 0.046f, true, 1.409f},  {0.370f, 0.046f, 0.046f, 0.045f, false, 1.409f},
        {0.455f, 0.041f, 0.039f, 0.042f, true, 1.410f},  {0.490f, 0.042f, 0.041f, 0.042f, false, 1.410f},
        {0.540f, 0.042f, 0.042f, 0.041f, false, 1.410f}, {0.610f, 0.036f, 0.037f, 0.036f, false, 1.410f},
        {0.690f, 0.027f, 0.031f, 0.030f, true, 1.410f},  {0.725f, 0.023f, 0.035f, 0.034f, false, 1.408f},
        {0.770f, 0.023f, 0.044f, 0.042f, false, 1.406f}, {0.820f, 0.020f, 0.041f, 0.041f, true, 1.403f},
        {0.865f, 0.014f, 0.028f, 0.030f, false, 1.399f}};
    static constexpr Section kNeck[]{{1.470f, 0.058f, 0.050f, 0.064f, true},
                                     {1.515f, 0.056f, 0.056f, 0.058f},
                                     {1.570f, 0.057f, 0.060f, 0.060f, true}};
    static constexpr Section kHead[]{
        {1.481f, 0.026f, 0.088f, -0.030f},      {1.493f, 0.050f, 0.104f, 0.012f, true},
        {1.520f, 0.066f, 0.110f, 0.050f},       {1.555f, 0.074f, 0.110f, 0.076f, true},
        {1.595f, 0.079f, 0.109f, 0.089f},       {1.640f, 0.081f, 0.109f, 0.094f},
        {1.680f, 0.078f, 0.102f, 0.089f, true}, {1.712f, 0.067f, 0.085f, 0.075f},
        {1.733f, 0.043f, 0.056f, 0.048f}};
    static const Shape kShape{kPelvis, kShirtRings, kLeg,   kSleeve, kArm,   kNeck, kHead, 6,   8,
                              0.055f,  0.795f,      1.605f, 1.525f,  0.013f, false, 1.0f,  1.0f};
    return kShape;
}

const Shape& narrowShape() {
    static constexpr Section kPelvis[]{{0.885f, 0.176f, 0.094f, 0.134f, true},
                                       {0.918f, 0.164f, 0.090f, 0.120f},
                                       {0.945f, 0.148f, 0.084f, 0.098f, true}};
    static constexpr Section kShirtRings[]{
        {0.915f, 0.183f, 0.107f, 0.142f, true}, {0.965f, 0.172f, 0.107f, 0.124f},
        {1.035f, 0.150f, 0.102f, 0.099f, true}, {1.105f, 0.139f, 0.099f, 0.086f},
        {1.170f, 0.142f, 0.108f, 0.088f},       {1.240f, 0.153f, 0.134f, 0.097f},
        {1.312f, 0.164f, 0.132f, 0.104f, true}, {1.383f, 0.166f, 0.107f, 0.106f},
        {1.442f, 0.153f, 0.078f, 0.093f, true}, {1.470f, 0.104f, 0.058f, 0.078f},
        {1.492f, 0.060f, 0.049f, 0.062f, true}};
    static constexpr Section kLeg[]{
        {0.770f, 0.087f, 0.092f, 0.104f, false, 0.090f}, {0.690f, 0.079f, 0.089f, 0.088f, true, 0.091f},
        {0.550f, 0.062f, 0.073f, 0.064f, true, 0.090f},  {0.505f, 0.058f, 0.070f, 0.060f, false, 0.090f},
        {0.465f, 0.056f, 0.065f, 0.061f, true, 0.090f},  {0.410f, 0.056f, 0.058f, 0.071f, false, 0.090f},
        {0.340f, 0.055f, 0.053f, 0.076f, false, 0.090f}, {0.260f, 0.050f, 0.049f, 0.064f, false, 0.090f},
        {0.086f, 0.049f, 0.057f, 0.061f, true, 0.090f}};
    static constexpr Section kSleeve[]{{0.200f, 0.054f, 0.055f, 0.057f, false, 1.405f},
                                       {0.240f, 0.055f, 0.053f, 0.055f, false, 1.407f},
                                       {0.315f, 0.053f, 0.052f, 0.052f, true, 1.408f}};
    static constexpr Section kArm[]{
        {0.295f, 0.040f, 0.039f, 0.039f, true, 1.409f},  {0.365f, 0.039f, 0.038f, 0.038f, false, 1.409f},
        {0.455f, 0.035f, 0.034f, 0.036f, true, 1.410f},  {0.490f, 0.036f, 0.035f, 0.036f, false, 1.410f},
        {0.540f, 0.036f, 0.036f, 0.035f, false, 1.410f}, {0.610f, 0.031f, 0.032f, 0.031f, false, 1.410f},
        {0.690f, 0.024f, 0.027f, 0.026f, true, 1.410f},  {0.725f, 0.021f, 0.031f, 0.030f, false, 1.408f},
        {0.770f, 0.021f, 0.039f, 0.038f, false, 1.406f}, {0.820f, 0.018f, 0.036f, 0.036f, true, 1.403f},
        {0.862f, 0.012f, 0.024f, 0.026f, false, 1.399f}};
    static constexpr Section kNeck[]{{1.465f, 0.050f, 0.042f, 0.056f, true},
                                     {1.515f, 0.047f, 0.048f, 0.050f},
                                     {1.570f, 0.049f, 0.052f, 0.054f, true}};
    static constexpr Section kHead[]{
        {1.482f, 0.022f, 0.085f, -0.036f},      {1.494f, 0.043f, 0.100f, 0.006f, true},
        {1.520f, 0.060f, 0.106f, 0.046f},       {1.555f, 0.071f, 0.107f, 0.074f, true},
        {1.595f, 0.077f, 0.107f, 0.088f},       {1.640f, 0.079f, 0.108f, 0.093f},
        {1.680f, 0.076f, 0.101f, 0.088f, true}, {1.712f, 0.065f, 0.084f, 0.074f},
        {1.733f, 0.042f, 0.055f, 0.047f}};
    static const Shape kShape{kPelvis, kShirtRings, kLeg,   kSleeve, kArm,   kNeck, kHead, 6,   8,
                              0.055f,  0.795f,      1.630f, 1.545f,  0.014f, true,  0.88f, 0.9f};
    return kShape;
}

}  // namespace muster::bodies
