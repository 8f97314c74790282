# The statistics of plumb report, who hunts seeded bugs, and the solutions of the six equations; of the other programs, only what
# they print is looked at.
target_link_libraries(test_reports PRIVATE plumb_campaign_report plumb_kills plumb_study fmt::fmt)
add_dependencies(test_reports bench plumb plumb-solve plumb-campaign plumb-replay plumb-report plumb-report-gate plumb-report-study)
