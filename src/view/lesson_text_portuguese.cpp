// The Portuguese words of the lesson pane.

#include "view/lesson_text.h"

namespace raywalk {

std::string_view portuguese(LessonWord word) {
  switch (word) {
    case LessonWord::lessons:
      return "Lições";
    case LessonWord::next:
      return "Próximo";
    case LessonWord::back:
      return "Voltar";
    case LessonWord::reveal:
      return "Revelar";
    case LessonWord::all_lessons:
      return "Todas as lições";
    case LessonWord::finish:
      return "Concluir";
    case LessonWord::presenter:
      return "Apresentador";
    case LessonWord::unlock:
      return "Liberar todas";
    case LessonWord::predict:
      return "Preveja";
    case LessonWord::drag_arrow:
      return "Arraste uma seta na planta";
    case LessonWord::type_number:
      return "Digite um número e Enter";
    case LessonWord::change:
      return "Agora mude algo";
    case LessonWord::teacher:
      return "Notas do professor";
    case LessonWord::right:
      return "Certo";
    case LessonWord::wrong:
      return "Não exatamente";
    case LessonWord::error:
      return "erro de";
    case LessonWord::of:
      return "de";
    case LessonWord::locked:
      return "Fechada: conclua antes a lição acima, ou escolha Liberar todas";
    case LessonWord::done:
      return "concluída";
    case LessonWord::hands:
      return "{0} de {1} mãos acertaram";
    case LessonWord::hands_hint:
      return "Mãos levantadas: 1, 2, ... contam uma mão; com Shift, uma a menos";
    case LessonWord::predict_first:
      return "Preveja primeiro; depois STEP mostra a resposta.";
    case LessonWord::back_to_question:
      return "De volta à pergunta";
    case LessonWord::not_a_number:
      return "Isto não é um número: digite um como 12,5";
    case LessonWord::presenter_hint:
      return "Para professores: contagem de mãos, roteiro e notas a pedido, e todas as lições abertas";
    case LessonWord::unlock_hint:
      return "Todas as lições e respostas abertas, sem previsão";
    case LessonWord::sources:
      return "Fontes";
    case LessonWord::hand_more:
      return "Mais uma mão";
    case LessonWord::hand_less:
      return "Menos uma mão";
    case LessonWord::extra:
      return "se houver tempo";
    case LessonWord::time:
      return "até {0} de {1}";
    case LessonWord::notes:
      return "Notas";
    case LessonWord::notes_hint:
      return "O que dizer, aqui no painel, onde a turma também o vê";
    case LessonWord::script:
      return "Roteiro...";
    case LessonWord::script_hint:
      return "A lição inteira como página só para você: para imprimir ou ler em outra tela";
    case LessonWord::no_lesson:
      return "O roteiro é de uma lição: abra uma primeiro (F2)";
    case LessonWord::script_screen:
      return "Na tela";
    case LessonWord::script_say:
      return "Dizer e fazer";
    case LessonWord::script_ask:
      return "Perguntar";
    case LessonWord::script_keys:
      return "Teclas: Enter revela a resposta e depois passa ao próximo passo. Page Down ou \u2192 avança uma linha, "
             "Page Up ou \u2190 volta. 1 a 9 contam as mãos de uma opção, com Shift uma a menos. P clareia a tela para "
             "o projetor, F11 ocupa a tela "
             "inteira, Ctrl + e Ctrl \u2212 aumentam ou diminuem tudo.";
    case LessonWord::close:
      return "Fechar a lição: a sua cena volta";
    case LessonWord::score:
      return "previsões certas de primeira";
  }
  return {};
}

}  // namespace raywalk
