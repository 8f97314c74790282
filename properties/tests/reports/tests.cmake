# The statistics of plumb report, and who hunts seeded bugs; of the other programs, only what they print is looked at.
target_link_libraries(test_reports PRIVATE plumb_campaign_report plumb_kills fmt::fmt)
add_dependencies(test_reports bench plumb plumb-solve plumb-campaign plumb-replay plumb-report plumb-report-gate)
