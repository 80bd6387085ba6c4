; Problem task-01 of the learned domain tabletop-paper, in numbers.
; How it came about: drawn with seed 2: one random action on item-01; draw 3, earlier ones met at the start or off the table.
; A goal is met within 50 mm; what is asked for lies inside that by as
; much as 10 step(s) with an object can err by rounding to 0.1 mm.
(define (problem task-01)
  (:domain tabletop-paper-numeric)
  (:objects
    item-01 - solid-narrow-10
    m-110-item-01 m-010c-item-01 m-100c-item-01 m-001-item-01 m-111-item-01 m-011c-item-01 - motion)
  (:init
    (hand-empty)
    ; item-01 lies at (0.6312, -0.0864, 0.0432) m at first
    (pushes item-01 m-110-item-01) (pushes item-01 m-010c-item-01) (pushes item-01 m-100c-item-01) (pushes item-01 m-001-item-01) (pushes item-01 m-111-item-01) (pushes item-01 m-011c-item-01)
    (= (x item-01) 2812) (= (y item-01) 2136) (= (z item-01) 0)
    (= (along-x m-110-item-01) 9436) (= (along-y m-110-item-01) 9678) (= (along-z m-110-item-01) 10000)
    (= (along-x m-010c-item-01) 9779) (= (along-y m-010c-item-01) 10151) (= (along-z m-010c-item-01) 10000)
    (= (along-x m-100c-item-01) 9486) (= (along-y m-100c-item-01) 9366) (= (along-z m-100c-item-01) 10000)
    (= (along-x m-001-item-01) 10677) (= (along-y m-001-item-01) 9856) (= (along-z m-001-item-01) 10000)
    (= (along-x m-111-item-01) 10224) (= (along-y m-111-item-01) 9688) (= (along-z m-111-item-01) 10000)
    (= (along-x m-011c-item-01) 10105) (= (along-y m-011c-item-01) 10252) (= (along-z m-011c-item-01) 10000)
    (= (total-cost) 0) (= (cost m-110-item-01) 12) (= (cost m-010c-item-01) 4) (= (cost m-100c-item-01) 9) (= (cost m-001-item-01) 9) (= (cost m-111-item-01) 4) (= (cost m-011c-item-01) 4)
  )
  (:goal (and (<= (x item-01) 3832) (>= (x item-01) 2922) (<= (+ (x item-01) (y item-01)) 6384) (>= (+ (x item-01) (y item-01)) 5097) (<= (y item-01) 2818) (>= (y item-01) 1909) (<= (+ (y item-01) 370) (x item-01)) (<= (x item-01) (+ (y item-01) 1657)) (>= (z item-01) 0) (<= (z item-01) 0)))
  (:metric minimize (total-cost)))
