; Problem swap of the learned domain toy, with a durative action.
; How it came about: by hand.
(define (problem swap)
  (:domain toy-durative)
  (:objects
    item-01 - cube
    item-02 - cube
    start-item-01 start-item-02 goal-item-01 goal-item-02 park-01 park-02 nowhere - place)
  (:init
    (hand-empty) (free nowhere)
    (stands item-01 start-item-01) (can-carry item-01)
    (stands item-02 start-item-02) (can-carry item-02)
    ; goal-item-01 lies at (0.8000, 0.1000) m
    (free goal-item-01) (room item-01 goal-item-01 start-item-02 nowhere nowhere)
    ; goal-item-02 lies at (0.5000, -0.1000) m
    (free goal-item-02) (room item-02 goal-item-02 start-item-01 nowhere nowhere)
    ; park-01 lies at (0.7699, -0.1174) m
    (free park-01) (room item-01 park-01 nowhere nowhere nowhere) (room item-02 park-01 nowhere nowhere nowhere)
    ; park-02 lies at (0.4659, -0.2466) m
    (free park-02) (room item-01 park-02 nowhere nowhere nowhere) (room item-02 park-02 nowhere nowhere nowhere)
  )
  (:goal (and (stands item-01 goal-item-01) (stands item-02 goal-item-02))))
