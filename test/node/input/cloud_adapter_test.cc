#include "node/input/cloud_adapter.h"

#include <gtest/gtest.h>
#include <sensor_msgs/point_cloud2_iterator.h>

#include <cmath>
#include <limits>

namespace place_memory::node {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

sensor_msgs::PointCloud cloudOf(const std::vector<CloudPoint>& points) {
  sensor_msgs::PointCloud cloud;
  cloud.header.stamp = ros::Time(10.0);
  cloud.header.frame_id = "/base_link";
  for (const CloudPoint& point : points) {
    geometry_msgs::Point32 p;
    p.x = static_cast<float>(point.x);
    p.y = static_cast<float>(point.y);
    cloud.points.push_back(p);
  }
  return cloud;
}

sensor_msgs::PointCloud2 cloud2Of(const std::vector<CloudPoint>& points) {
  sensor_msgs::PointCloud2 cloud;
  cloud.header.stamp = ros::Time(10.0);
  cloud.header.frame_id = "base_link";
  sensor_msgs::PointCloud2Modifier modifier(cloud);
  modifier.setPointCloud2FieldsByString(1, "xyz");
  modifier.resize(points.size());
  sensor_msgs::PointCloud2Iterator<float> x(cloud, "x");
  sensor_msgs::PointCloud2Iterator<float> y(cloud, "y");
  for (const CloudPoint& point : points) {
    *x = static_cast<float>(point.x);
    *y = static_cast<float>(point.y);
    ++x;
    ++y;
  }
  return cloud;
}

class CloudAdapterTest : public testing::Test {
 protected:
  CloudAdapter& adapter() {
    if (!adapter_) adapter_.emplace("/sonar", parameters_, registry_);
    return *adapter_;
  }

  config::Parameters parameters_;
  SensorRegistry registry_;
  std::optional<CloudAdapter> adapter_;
};

TEST_F(CloudAdapterTest, BothKindsOfCloudSayTheSame) {
  parameters_.cloud.mounts = {{0.1, 0.0, 0.0}, {0.0, 0.1, core::kPi / 2}};
  const std::vector<CloudPoint> points{{1.1, 0.0}, {0.0, 2.1}};
  const auto one = adapter().adapt(cloudOf(points));
  const auto two = adapter().adapt(cloud2Of(points));
  ASSERT_EQ(one.size(), 2U);
  ASSERT_EQ(two.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_FALSE(one[i].reject);
    EXPECT_NEAR(one[i].measurement.range, i == 0 ? 1.0 : 2.0, 1e-6);
    EXPECT_EQ(one[i].measurement.range, two[i].measurement.range);
    EXPECT_EQ(one[i].measurement.sensor, two[i].measurement.sensor);
    EXPECT_EQ(one[i].measurement.frame, "base_link");
    EXPECT_EQ(one[i].measurement.frame_from_sensor.yaw, parameters_.cloud.mounts[i].yaw);
    EXPECT_EQ(one[i].measurement.spec.max_range, parameters_.cloud.max_range);
  }
  EXPECT_NE(one[0].measurement.sensor, one[1].measurement.sensor);
  EXPECT_EQ(registry_.nameOf(one[1].measurement.sensor), "sonar 1 of /sonar");
}

TEST_F(CloudAdapterTest, APointAtTheOriginOrAtMaxRangeIsNoEcho) {
  parameters_.cloud.mounts = {{0.1, 0.0, 0.0}};
  for (const double x : {0.0, 5.1, 5.0996, 7.0, kInf}) {
    const auto readings = adapter().adapt(cloudOf({{x, 0.0}}));
    ASSERT_FALSE(readings.front().reject) << x;
    EXPECT_EQ(readings.front().measurement.range, kInf) << x;
  }
  EXPECT_NEAR(adapter().adapt(cloudOf({{5.0, 0.0}})).front().measurement.range, 4.9, 1e-6);
  EXPECT_EQ(adapter().adapt(cloudOf({{std::nan(""), 0.0}})).front().reject, Reject::kNan);
}

TEST_F(CloudAdapterTest, APointOnASonarOrBehindItIsARangeOfZeroOrLess) {
  parameters_.cloud.mounts = {{0.069, 0.136, core::kPi / 2}};
  const auto at = [&](double y) { return adapter().adapt(cloudOf({{0.069, y}})).front(); };
  for (const double y : {0.136, -0.864}) {  // 0 and -1
    EXPECT_FALSE(at(y).reject) << at(y).sensor_problem;
    EXPECT_EQ(at(y).measurement.range, kInf) << "no echo, as with Range messages";
    ASSERT_TRUE(at(y).no_echo) << "and it is said";
    EXPECT_NEAR(at(y).no_echo->range, y > 0.0 ? 0.0 : -1.0, 1e-6);
  }
  EXPECT_NEAR(at(0.636).measurement.range, 0.5, 1e-6);
  parameters_.no_echo.zero = false;
  EXPECT_EQ(at(0.136).measurement.range, 0.0);
  EXPECT_EQ(at(-0.864).reject, Reject::kBelowMinRange);
}

TEST_F(CloudAdapterTest, MillimetresAreNoWordForNoEcho) {
  parameters_.cloud.mounts = {{0.1, 0.0, 0.0}};
  EXPECT_EQ(adapter().adapt(cloudOf({{1500.0, 0.0}})).front().reject, Reject::kAboveMaxRange);
  EXPECT_FALSE(adapter().adapt(cloudOf({{3e38, 0.0}})).front().reject) << "the largest float";
  parameters_.scan.over_range_is_no_echo = true;
  EXPECT_FALSE(adapter().adapt(cloudOf({{1500.0, 0.0}})).front().reject);
}

TEST_F(CloudAdapterTest, AnEchoWhereASonarDoesNotLookIsNamed) {
  parameters_.cloud.mounts = {{0.069, 0.136, core::kPi / 2}};
  const AdaptedReading mirrored = adapter().adapt(cloudOf({{0.2, -1.136}})).front();
  EXPECT_EQ(mirrored.reject, Reject::kBadSensor);
  EXPECT_NE(mirrored.sensor_problem.find("174 degrees to the right"), std::string::npos)
      << mirrored.sensor_problem;
  EXPECT_NE(mirrored.sensor_problem.find("cloud/mounts"), std::string::npos);
  EXPECT_FALSE(adapter().adapt(cloudOf({{0.3, 1.136}})).front().reject) << "the edge of its cone";
  EXPECT_FALSE(adapter().adapt(cloudOf({{0.2, 0.1}})).front().reject) << "a mount is a little off";
}

TEST_F(CloudAdapterTest, WhereASensorLooksIsInferredFromItsPoints) {
  const core::Pose2d mount{0.08, 0.15, 1.4};
  const auto pointAt = [&](double range) {
    const core::Pose2d at = mount * core::Pose2d{range, 0.0, 0.0};
    return CloudPoint{at.x, at.y};
  };
  core::Measurement measurement;
  for (int i = 0; i < 12; ++i) {
    const CloudPoint point = pointAt(0.6 + 0.2 * i);
    const AdaptedReading reading = adapter().adapt(cloudOf({point})).front();
    ASSERT_FALSE(reading.reject);
    measurement = reading.measurement;
    const core::Pose2d echo =
        measurement.frame_from_sensor * core::Pose2d{measurement.range, 0.0, 0.0};
    EXPECT_NEAR(echo.x, point.x, 1e-3) << "the echo lies where the driver says";
    EXPECT_NEAR(echo.y, point.y, 1e-3);
  }
  EXPECT_NEAR(measurement.frame_from_sensor.yaw, 1.4, 1e-4);
  const AdaptedReading none = adapter().adapt(cloudOf({{0.0, 0.0}})).front();
  ASSERT_FALSE(none.reject);
  EXPECT_EQ(none.measurement.range, kInf);
  EXPECT_NEAR(none.measurement.frame_from_sensor.yaw, 1.4, 1e-4);
}

TEST_F(CloudAdapterTest, NothingIsSaidOfASensorThatNeverHeardAnything) {
  EXPECT_EQ(adapter().adapt(cloudOf({{0.0, 0.0}})).front().reject, Reject::kNoMount);
}

TEST_F(CloudAdapterTest, PointsOnNoRayAreTakenEachForItself) {
  for (int i = 0; i < 40; ++i) {
    const double bearing = 0.3 * i;
    const AdaptedReading reading =
        adapter().adapt(cloudOf({{2.0 * std::cos(bearing), 2.0 * std::sin(bearing)}})).front();
    EXPECT_NEAR(reading.measurement.range, 2.0, 1e-6);
    EXPECT_NEAR(core::wrapAngle(reading.measurement.frame_from_sensor.yaw - bearing), 0.0, 1e-6);
  }
}

void expectProblem(const std::vector<AdaptedReading>& readings, const std::string& word) {
  ASSERT_EQ(readings.size(), 1U) << word;
  EXPECT_EQ(readings.front().reject, Reject::kBadSensor) << word;
  EXPECT_NE(readings.front().sensor_problem.find(word), std::string::npos)
      << readings.front().sensor_problem;
}

TEST_F(CloudAdapterTest, CloudsThatAreNoRingAreNamed) {
  expectProblem(adapter().adapt(cloudOf({})), "no points");
  expectProblem(adapter().adapt(cloudOf(std::vector<CloudPoint>(65, {1.0, 0.0}))), "65 points");
  parameters_.cloud.mounts.resize(2);
  expectProblem(adapter().adapt(cloudOf({{1.0, 0.0}})), "cloud/mounts 2 poses");
}

TEST_F(CloudAdapterTest, ALayoutThatCannotBeIsNamed) {
  const sensor_msgs::PointCloud2 good = cloud2Of({{1.0, 0.0}, {0.0, 1.0}});
  sensor_msgs::PointCloud2 cloud = good;
  cloud.fields.erase(cloud.fields.begin());
  expectProblem(adapter().adapt(cloud), "no field x");
  cloud = good;
  cloud.fields[1].datatype = sensor_msgs::PointField::INT16;
  expectProblem(adapter().adapt(cloud), "field y");
  cloud = good;
  cloud.fields[0].offset = 0xFFFFFFFFU;
  expectProblem(adapter().adapt(cloud), "beyond point_step");
  cloud = good;
  cloud.data.resize(cloud.data.size() - 1);
  expectProblem(adapter().adapt(cloud), "less data");
  cloud = good;
  cloud.width = 0xFFFFFFFFU;
  cloud.height = 0xFFFFFFFFU;
  expectProblem(adapter().adapt(cloud), "points");
  cloud = good;
  cloud.height = 2;
  cloud.row_step = 0xFFFFFFFFU;
  expectProblem(adapter().adapt(cloud), "less data");
  cloud = good;
  cloud.is_bigendian = 1;
  expectProblem(adapter().adapt(cloud), "big-endian");
}

TEST_F(CloudAdapterTest, RefusesAFrameThatIsNoName) {
  sensor_msgs::PointCloud cloud = cloudOf({{1.0, 0.0}});
  cloud.header.frame_id = std::string(1000000, 'x');
  const AdaptedReading reading = adapter().adapt(cloud).front();
  EXPECT_EQ(reading.reject, Reject::kBadSensor);
  EXPECT_NE(reading.sensor_problem.find("1000000 bytes"), std::string::npos);
  EXPECT_LT(reading.measurement.frame.size(), 100U);
}

TEST_F(CloudAdapterTest, NeedsAStamp) {
  sensor_msgs::PointCloud cloud = cloudOf({{1.0, 0.0}});
  cloud.header.stamp = ros::Time();
  EXPECT_EQ(adapter().adapt(cloud).front().reject, Reject::kNoStamp);
}

TEST_F(CloudAdapterTest, RaysOfEveryBearingAreFound) {
  for (int k = 0; k < 16; ++k) {
    const core::Pose2d mount =
        core::Pose2d{0.0, 0.0, k * core::kPi / 8} * core::Pose2d{0.2, 0.0, 0.1};
    RayFit ray;
    for (int i = 0; i < 20; ++i) {
      const core::Pose2d at = mount * core::Pose2d{0.5 + 0.1 * i, 0.001 * (i % 3), 0.0};
      ray.add({at.x, at.y});
    }
    ASSERT_TRUE(ray.mount());
    EXPECT_NEAR(core::wrapAngle(ray.mount()->yaw - mount.yaw), 0.0, 0.01) << k;
  }
}

}  // namespace
}  // namespace place_memory::node
